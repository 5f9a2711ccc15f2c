// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <rigor/mesh/collada_positions.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

using xml::Element;

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

/// Indices as a <p> holds them: for each corner one of each input, side by side.
struct Layout {
  std::uint64_t stride = 1;
  std::uint64_t offset = 0;   ///< of the vertex
  std::string_view vertices;  ///< url; empty without a VERTEX input
};

Layout layout_of(Element group) {
  Layout layout;
  for (const Element input : group.children()) {
    if (input.name() != "input") continue;
    const std::uint64_t offset = count_of(input, "offset").value_or(0);
    // More inputs than numbers in the longest text: the <p> then ends inside its first corner.
    layout.stride = std::max(layout.stride, std::min<std::uint64_t>(offset, kMaxMeshBytes) + 1);
    if (value(input, "semantic") != "VERTEX") continue;
    layout.offset = offset;
    layout.vertices = value(input, "source");
  }
  return layout;
}

/// The vertices that the corners of a <p> name, one by one.
class CornerReader {
 public:
  CornerReader(std::string_view text, const Layout& layout) : cursor_(text), layout_(layout) {}

  /// Nothing at the end, or when something is no index.
  std::optional<std::uint32_t> next() {
    std::uint32_t vertex = kNoVertex;
    for (std::uint64_t i = 0; i < layout_.stride; ++i) {
      cursor_.skip_space();
      if (i == 0 && cursor_.at_end()) return std::nullopt;
      const std::optional<std::int64_t> index = cursor_.whole_number();
      if (!index) {
        failed_ = true;
        return std::nullopt;
      }
      const bool possible = *index >= 0 && *index < std::int64_t{kNoVertex};
      if (i == layout_.offset && possible) vertex = static_cast<std::uint32_t>(*index);
    }
    return vertex;
  }

  bool at_end() {
    cursor_.skip_space();
    return cursor_.at_end();
  }
  bool failed() const { return failed_; }  ///< at something that is no index

 private:
  TextCursor cursor_;
  const Layout& layout_;
  bool failed_ = false;
};

class Reader {
 public:
  Reader(const ColladaIndex& index, Element geometry) : index_(index), geometry_(geometry) {}

  ColladaGeometry run() {
    shape_.name = value(geometry_, "name");
    if (shape_.name.empty()) shape_.name = value(geometry_, "id");
    if (const std::optional<Element> mesh = geometry_.child("mesh")) {
      for (const Element child : mesh->children()) {
        if (!failed_) group(child);
      }
    }
    if (!failed_ && !shape_.groups.empty()) positions();
    if (!failed_ && missing_ > 0) {
      shape_.faults.push_back({FaultKind::kTruncated, {}, missing_, index_.line(geometry_)});
    }
    return std::move(shape_);
  }

 private:
  // ---- Groups

  void group(Element element) {
    const std::string_view kind = element.name();
    const bool whole =
        kind == "polygons" || kind == "trifans" || kind == "tristrips" || kind == "linestrips";
    if (!whole && kind != "triangles" && kind != "polylist" && kind != "lines") return;
    const Layout layout = layout_of(element);
    group_ = {.material = value(element, "material"), .line = index_.line(element)};
    if (whole) {
      for (const Element p : element.children()) {
        if (p.name() == "p" && !failed_) whole_list(p, kind, layout);
        if (p.name() == "ph") fail(FaultKind::kMalformed, "a polygon has holes", p);
      }
    } else if (const std::optional<Element> p = element.child("p")) {
      faces(element, *p, layout);
    } else {
      missing_ += count_of(element, "count").value_or(0);
    }
    if (failed_ || group_.triangles.empty()) return;
    if (layout.vertices.empty() || (!vertices_.empty() && vertices_ != layout.vertices)) {
      return fail(FaultKind::kMalformed, "the corners name no vertices, or several", element);
    }
    vertices_ = layout.vertices;
    shape_.triangles += group_.triangles.size();
    shape_.groups.push_back(std::move(group_));
  }

  /// As many faces as the count, or the list of sizes, says; less when the indices end before. One
  /// that is not whole is none.
  void faces(Element element, Element p, const Layout& layout) {
    const std::string_view kind = element.name();
    const std::optional<Element> vcount = element.child("vcount");
    TextCursor sizes(vcount ? vcount->text() : std::string_view());
    CornerReader corners(p.text(), layout);
    const std::uint64_t promised = count_of(element, "count").value_or(0);
    std::uint64_t held = 0;
    while (!failed_ && !corners.at_end()) {
      std::int64_t size = kind == "lines" ? 2 : 3;
      if (kind == "polylist") {
        sizes.skip_space();
        size = sizes.whole_number().value_or(0);
        if (size <= 0) return fail(FaultKind::kMalformed, "indices are left over", p);
      }
      if (!fan(corners, static_cast<std::uint64_t>(size))) break;
      ++held;
    }
    if (corners.failed()) return fail(FaultKind::kMalformed, "an index is no number", p);
    if (p.lost_text().size() > 0) return fail(FaultKind::kMalformed, "a list is interrupted", p);
    if (held < promised) missing_ += promised - held;
  }

  /// One polygon, fan or strip that takes all of the <p>.
  void whole_list(Element p, std::string_view kind, const Layout& layout) {
    CornerReader corners(p.text(), layout);
    if (kind == "tristrips") {
      strip(corners);
    } else if (kind == "linestrips") {
      std::uint64_t count = 0;
      while (corners.next()) ++count;
      shape_.passed_over += count > 0 ? count - 1 : 0;
    } else {
      fan(corners, std::numeric_limits<std::uint64_t>::max());
    }
    if (corners.failed()) fail(FaultKind::kMalformed, "an index is no number", p);
  }

  /// A face of `size` corners, or of all that there are when that is less; whether it is whole.
  bool fan(CornerReader& corners, std::uint64_t size) {
    const bool all = size == std::numeric_limits<std::uint64_t>::max();
    const std::size_t before = group_.triangles.size();
    Triangle t{};
    std::uint64_t held = 0;
    for (; held < size; ++held) {
      const std::optional<std::uint32_t> corner = corners.next();
      if (!corner) break;
      t[std::min<std::size_t>(held, 2)] = *corner;
      if (held < 2) continue;
      add(t);
      t[1] = t[2];
    }
    const bool whole = all || held == size;
    if (!whole) group_.triangles.resize(before);
    if (whole && held > 0 && held < 3) ++shape_.passed_over;
    return whole;
  }

  /// Every other triangle of a strip runs against its corners' order.
  void strip(CornerReader& corners) {
    Triangle last{};
    for (std::uint64_t held = 0;; ++held) {
      const std::optional<std::uint32_t> corner = corners.next();
      if (!corner) return;
      last = {last[1], last[2], *corner};
      if (held < 2) continue;
      add(held % 2 == 0 ? last : Triangle{last[1], last[0], last[2]});
    }
  }

  void add(const Triangle& t) {
    if (group_.triangles.size() == kMaxTriangles) {
      return fail(FaultKind::kTooLarge, "over 50 million triangles", geometry_);
    }
    if (!failed_) group_.triangles.push_back(t);
  }

  // ---- Positions

  void positions() {
    const ColladaPositions source = read_collada_positions(index_, vertices_);
    shape_.bytes_read = source.bytes_read;
    if (source.problem) return fail(FaultKind::kMalformed, source.problem, geometry_);
    const std::vector<Vector3>& all = source.positions;
    std::vector<std::uint32_t> place(all.size(), kNoVertex);
    Fault out_of_range{.kind = FaultKind::kIndexOutOfRange};
    std::uint64_t not_finite = 0;
    for (ColladaGroup& group : shape_.groups) {
      for (Triangle& t : group.triangles) {
        for (std::uint32_t& corner : t) {
          if (corner >= all.size()) {
            if (out_of_range.count++ == 0) out_of_range.line = group.line;
            continue;
          }
          if (place[corner] == kNoVertex) {
            const Vector3& p = all[corner];
            not_finite += !std::isfinite(p.x) + !std::isfinite(p.y) + !std::isfinite(p.z);
            place[corner] = static_cast<std::uint32_t>(shape_.positions.size());
            shape_.positions.push_back(p);
          }
          corner = place[corner];
        }
      }
    }
    if (out_of_range.count > 0) shape_.faults.push_back(out_of_range);
    if (not_finite > 0) {
      shape_.faults.push_back({FaultKind::kNotFinite, {}, not_finite, index_.line(geometry_)});
    }
  }

  void fail(FaultKind kind, const char* detail, Element at) {
    if (!failed_) shape_.faults.push_back({kind, detail, 0, index_.line(at)});
    failed_ = true;
  }

  const ColladaIndex& index_;
  Element geometry_;
  ColladaGeometry shape_;
  ColladaGroup group_;
  std::string_view vertices_;  ///< url, the same for all groups
  std::uint64_t missing_ = 0;  ///< faces that the counts promise
  bool failed_ = false;
};

}  // namespace

ColladaGeometry read_collada_geometry(const ColladaIndex& index, Element geometry) {
  return Reader(index, geometry).run();
}

}  // namespace rigor::mesh
