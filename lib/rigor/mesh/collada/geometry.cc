// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <rigor/mesh/collada/source.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

using xml::Element;

/// Of a triangle, or the last three of a polygon.
using ColladaTriangle = std::array<ColladaCorner, 3>;

class ColladaGeometryReader {
 public:
  ColladaGeometryReader(const ColladaIndex& index, Element geometry, std::uint64_t max_bytes)
      : index_(index), geometry_(geometry), max_bytes_(max_bytes) {}

  ColladaGeometry run() {
    shape_.name = value(geometry_, "name");
    if (shape_.name.empty()) shape_.name = value(geometry_, "id");
    if (const std::optional<Element> mesh = geometry_.child("mesh")) {
      for (const Element child : mesh->children()) {
        if (!failed_) group(child);
      }
    }
    if (!failed_ && !shape_.groups.empty()) values();
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
    const ColladaInputs inputs = collada_inputs(element);
    group_ = {.material = value(element, "material"), .line = index_.line(element)};
    for (std::size_t i = 0; i < kColladaKinds; ++i) group_.sources[i] = inputs.of[i].source;
    if (whole) {
      for (const Element p : element.children()) {
        if (p.name() == "p" && !failed_) whole_list(p, kind, inputs);
        if (p.name() == "ph") fail(FaultKind::kMalformed, "a polygon has holes", p);
      }
    } else if (const std::optional<Element> p = element.child("p")) {
      faces(element, *p, inputs);
    } else {
      missing_ += count_of(element, "count").value_or(0);
    }
    const std::size_t triangles = group_.corners[kColladaPosition].size();
    if (failed_ || triangles == 0) return;
    const std::string_view vertices = group_.sources[kColladaPosition];
    if (vertices.empty() || (!vertices_.empty() && vertices_ != vertices)) {
      return fail(FaultKind::kMalformed, "the corners name no vertices, or several", element);
    }
    vertices_ = vertices;
    shape_.triangles += triangles;
    shape_.groups.push_back(std::move(group_));
  }

  /// As many faces as the count, or the list of sizes, says; less when the indices end before. One
  /// that is not whole is none.
  void faces(Element element, Element p, const ColladaInputs& inputs) {
    const std::string_view kind = element.name();
    const std::optional<Element> vcount = element.child("vcount");
    TextCursor sizes(vcount ? vcount->text() : std::string_view());
    ColladaCornerReader corners(p.text(), inputs);
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
  void whole_list(Element p, std::string_view kind, const ColladaInputs& inputs) {
    ColladaCornerReader corners(p.text(), inputs);
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
  bool fan(ColladaCornerReader& corners, std::uint64_t size) {
    const bool all = size == std::numeric_limits<std::uint64_t>::max();
    const std::size_t before = group_.corners[kColladaPosition].size();
    ColladaTriangle t{};
    std::uint64_t held = 0;
    for (; held < size; ++held) {
      const std::optional<ColladaCorner> corner = corners.next();
      if (!corner) break;
      t[std::min<std::size_t>(held, 2)] = *corner;
      if (held < 2) continue;
      add(t);
      t[1] = t[2];
    }
    const bool whole = all || held == size;
    if (!whole) {
      for (std::vector<Triangle>& list : group_.corners) list.resize(std::min(before, list.size()));
    }
    if (whole && held > 0 && held < 3) ++shape_.passed_over;
    return whole;
  }

  /// Every other triangle of a strip runs against its corners' order.
  void strip(ColladaCornerReader& corners) {
    ColladaTriangle last{};
    for (std::uint64_t held = 0;; ++held) {
      const std::optional<ColladaCorner> corner = corners.next();
      if (!corner) return;
      last = {last[1], last[2], *corner};
      if (held < 2) continue;
      add(held % 2 == 0 ? last : ColladaTriangle{last[1], last[0], last[2]});
    }
  }

  void add(const ColladaTriangle& t) {
    if (failed_) return;
    for (std::size_t kind = 0; kind < kColladaKinds; ++kind) {
      const bool carried = kind == kColladaPosition || !group_.sources[kind].empty();
      if (carried && make_room(1))
        group_.corners[kind].push_back({t[0][kind], t[1][kind], t[2][kind]});
    }
  }

  bool make_room(std::uint64_t triangles) {
    lists_ += triangles;
    if (lists_ > kMaxTriangles) fail(FaultKind::kTooLarge, "over 50 million triangles", geometry_);
    return !failed_;
  }

  // ---- Values

  void values() {
    if (!look_at_vertices()) return;
    for (std::size_t kind = 0; kind < kColladaKinds; ++kind) gather(kind);
    if (out_of_range_.count > 0) shape_.faults.push_back(out_of_range_);
    if (not_finite() > 0) {
      shape_.faults.push_back({FaultKind::kNotFinite, {}, not_finite(), index_.line(geometry_)});
    }
  }

  /// What stands with the positions has their indices; a group's own inputs go before it.
  bool look_at_vertices() {
    const std::optional<Element> vertices = index_.find(vertices_, "vertices");
    const ColladaInputs inputs = vertices ? collada_inputs(*vertices) : ColladaInputs();
    for (ColladaGroup& group : shape_.groups) {
      group.sources[kColladaPosition] = inputs.of[kColladaPosition].source;
      for (std::size_t kind = 1; kind < kColladaKinds; ++kind) {
        if (!group.sources[kind].empty() || inputs.of[kind].source.empty()) continue;
        if (!make_room(group.corners[kColladaPosition].size())) return false;
        group.sources[kind] = inputs.of[kind].source;
        group.corners[kind] = group.corners[kColladaPosition];
      }
    }
    return true;
  }

  /// Reads each source once, for all groups that draw on it.
  void gather(std::size_t kind) {
    std::map<std::string_view, std::vector<ColladaGroup*>> users;
    for (ColladaGroup& group : shape_.groups) {
      if (!group.corners[kind].empty()) users[group.sources[kind]].push_back(&group);
    }
    for (const auto& [source, groups] : users) {
      if (failed_) return;
      const ColladaNumbers read = read_collada_source(index_, source, kColladaWidths[kind]);
      shape_.bytes_read += read.bytes_read;
      if (read.problem) return fail(FaultKind::kMalformed, read.problem, geometry_);
      if (shape_.bytes_read > max_bytes_) {
        return fail(FaultKind::kTooLarge, "the same numbers are read over and over", geometry_);
      }
      keep_used(kind, read.numbers, groups);
    }
  }

  void keep_used(std::size_t kind, const std::vector<double>& all,
                 const std::vector<ColladaGroup*>& groups) {
    const std::size_t width = kColladaWidths[kind];
    std::vector<double>& kept = shape_.values[kind];
    std::vector<std::uint32_t> place(all.size() / width, kNoColladaIndex);
    for (ColladaGroup* group : groups) {
      for (Triangle& t : group->corners[kind]) {
        for (std::uint32_t& corner : t) {
          if (corner >= place.size()) {
            if (out_of_range_.count++ == 0) out_of_range_.line = group->line;
            continue;
          }
          if (place[corner] == kNoColladaIndex) {
            place[corner] = static_cast<std::uint32_t>(kept.size() / width);
            const auto from = all.begin() + static_cast<std::ptrdiff_t>(corner * width);
            kept.insert(kept.end(), from, from + static_cast<std::ptrdiff_t>(width));
          }
          corner = place[corner];
        }
      }
    }
  }

  std::uint64_t not_finite() const {
    const std::vector<double>& positions = shape_.values[kColladaPosition];
    return static_cast<std::uint64_t>(std::count_if(positions.begin(), positions.end(),
                                                    [](double x) { return !std::isfinite(x); }));
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
  std::uint64_t max_bytes_;
  std::uint64_t lists_ = 0;    ///< triangles, once for each kind that their corners have
  std::uint64_t missing_ = 0;  ///< faces that the counts promise
  Fault out_of_range_{.kind = FaultKind::kIndexOutOfRange};
  bool failed_ = false;
};

}  // namespace

ColladaGeometry read_collada_geometry(const ColladaIndex& index, Element geometry,
                                      std::uint64_t max_bytes) {
  return ColladaGeometryReader(index, geometry, max_bytes).run();
}

}  // namespace rigor::mesh
