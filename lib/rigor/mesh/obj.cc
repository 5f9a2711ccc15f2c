// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/obj.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

// More parts are refused, and of a longer name only this much is kept: each part repeats the names,
// so a file that switches often between long ones would take more memory than any mesh.
constexpr std::size_t kMaxParts = 1'000'000;
constexpr std::size_t kMaxNameBytes = 256;

// As many as 32 bits can tell apart.
constexpr std::uint64_t kAnyNumber = std::uint64_t{1} << 32U;

class Reader {
 public:
  /// `vertices` is how many the file has: faces may name some that come later.
  Reader(std::string_view bytes, std::uint64_t vertices)
      : bytes_(bytes), cursor_(bytes), vertices_(vertices) {}

  LoadedMesh run() {
    for (; loaded_.faults.empty() && !cursor_.at_end(); cursor_.skip_line()) statement();
    if (loaded_.faults.empty()) {
      // Now their number is known: once more, to count and find the faces that were wrong.
      if (used_ > mesh_.positions.size()) return Reader(bytes_, mesh_.positions.size()).run();
      judge();
    }
    if (loaded_.usable()) loaded_.mesh = std::move(mesh_);
    return std::move(loaded_);
  }

 private:
  void statement() {
    cursor_.skip_blanks();
    const std::string_view word = cursor_.word();
    if (word == "v") {
      vertex();
    } else if (word == "f") {
      face();
    } else if (word == "o" || word == "g") {
      name_ = cursor_.rest_of_line().substr(0, kMaxNameBytes);
      part_named_ = true;
    } else if (word == "usemtl") {
      material_ = cursor_.rest_of_line().substr(0, kMaxNameBytes);
      part_named_ = true;
    } else if (word == "l" || word == "p" || word == "curv" || word == "curv2" || word == "surf") {
      not_triangles_.add(cursor_.offset());
    }
  }

  /// What follows the third number, a weight or a colour, does not matter to polygons.
  void vertex() {
    if (mesh_.positions.size() == kMaxTriangles) {
      return stop(FaultKind::kTooLarge, "over 50 million vertices");
    }
    Vector3 p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) {
      const std::optional<double> number = cursor_.number();
      if (!number) return stop(FaultKind::kMalformed, "a vertex has no three numbers");
      *coordinate = *number;
      if (!std::isfinite(*number)) not_finite_.add(cursor_.offset());
    }
    mesh_.positions.push_back(p);
  }

  void face() {
    Triangle t{};
    std::size_t corners = 0;
    for (cursor_.skip_blanks(); !cursor_.at_line_end(); cursor_.skip_blanks()) {
      const std::optional<std::uint32_t> vertex = corner();
      if (!vertex) return stop(FaultKind::kMalformed, "a face has a corner that is no index");
      t[std::min<std::size_t>(corners, 2)] = *vertex;
      if (++corners < 3) continue;
      if (!append(t)) return;
      t[1] = t[2];
    }
    if (corners < 3) not_triangles_.add(cursor_.offset());
  }

  /// `7`, `7/1`, `7/1/2` or `7//2`; -1 is the last vertex so far.
  std::optional<std::uint32_t> corner() {
    const std::optional<std::int64_t> written = cursor_.whole_number();
    const std::string_view rest = cursor_.word();
    if (!written || !(rest.empty() || rest.front() == '/')) return std::nullopt;
    // What would be before the first vertex wraps to above all.
    const std::uint64_t before = *written < 0 ? mesh_.positions.size() : std::uint64_t{0} - 1;
    const std::uint64_t index = before + static_cast<std::uint64_t>(*written);
    if (index >= vertices_) out_of_range_.add(cursor_.offset());
    if (index < vertices_) used_ = std::max(used_, index + 1);
    return static_cast<std::uint32_t>(index);
  }

  bool append(const Triangle& t) {
    std::vector<Part>& parts = mesh_.parts;
    if (parts.empty() ||
        (part_named_ && (parts.back().name != name_ || parts.back().material != material_))) {
      parts.push_back({name_, material_, mesh_.triangles.size()});
    }
    part_named_ = false;
    mesh_.triangles.push_back(t);
    ++parts.back().count;
    if (mesh_.triangles.size() > kMaxTriangles) {
      stop(FaultKind::kTooLarge, "over 50 million triangles");
    } else if (parts.size() > kMaxParts) {
      stop(FaultKind::kTooLarge, "over a million parts");
    }
    return loaded_.faults.empty();
  }

  void stop(FaultKind kind, const char* detail) {
    loaded_.faults.push_back({kind, detail, 0, line_at(bytes_, cursor_.offset())});
  }

  void judge() {
    const auto add = [this](FaultKind kind, const Tally& tally) {
      if (tally.count > 0) loaded_.faults.push_back(fault_at(tally, kind, bytes_));
    };
    add(FaultKind::kIndexOutOfRange, out_of_range_);
    add(FaultKind::kNotFinite, not_finite_);
    if (mesh_.triangles.empty()) loaded_.faults.push_back({FaultKind::kEmpty});
    add(FaultKind::kNotTriangles, not_triangles_);
    add(FaultKind::kDecimalComma, cursor_.decimal_commas());
  }

  std::string_view bytes_;
  TextCursor cursor_;
  std::uint64_t vertices_;
  std::uint64_t used_ = 0;  ///< the highest number of a vertex that a face names
  LoadedMesh loaded_{.format = Format::kObj};
  TriangleMesh mesh_;
  std::string name_;
  std::string material_;
  bool part_named_ = false;  ///< since the last face
  Tally out_of_range_;
  Tally not_finite_;
  Tally not_triangles_;
};

}  // namespace

LoadedMesh read_obj(std::string_view bytes) { return Reader(bytes, kAnyNumber).run(); }

}  // namespace rigor::mesh
