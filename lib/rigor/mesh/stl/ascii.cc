// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/stl/ascii.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

/// Functions that return false have met what ends the reading.
class AsciiStlReader {
 public:
  explicit AsciiStlReader(std::string_view bytes) : bytes_(bytes), cursor_(bytes) {}

  LoadedMesh run() {
    if (cursor_.accept("solid")) {
      while (solid() && cursor_.accept("solid")) {
      }
    } else {
      missing("solid");
    }
    if (loaded_.usable()) judge();
    if (!loaded_.usable()) loaded_.mesh = {};
    return std::move(loaded_);
  }

 private:
  /// From behind the word `solid`.
  bool solid() {
    ++solids_;
    TriangleMesh& mesh = loaded_.mesh;
    Part part{std::string(cursor_.rest_of_line()), {}, mesh.triangles.size()};
    bool good = true;
    while (good && cursor_.accept("facet")) good = facet();
    part.count = mesh.triangles.size() - part.first;
    if (part.count > 0) mesh.parts.push_back(std::move(part));
    return good && end_of_solid();
  }

  bool end_of_solid() {
    if (cursor_.accept("endsolid")) {
      cursor_.skip_line();
      return true;
    }
    endsolid_missing_ = true;
    return cursor_.sees("solid") || missing("facet or endsolid");
  }

  /// From behind the word `facet`.
  bool facet() {
    in_facet_ = true;
    if (!cursor_.accept("normal")) return missing("normal");
    for (int i = 0; i < 3; ++i) {
      cursor_.skip_space();
      cursor_.word();
    }
    if (!cursor_.accept("outer") || !cursor_.accept("loop")) return missing("outer loop");
    Facet corners;
    for (Vector3& corner : corners) {
      if (!vertex(corner)) return missing("vertex with three numbers");
    }
    if (!cursor_.accept("endloop")) return missing("endloop");
    if (!cursor_.accept("endfacet")) return missing("endfacet");
    in_facet_ = false;
    return append(corners);
  }

  bool vertex(Vector3& into) {
    if (!cursor_.accept("vertex")) return false;
    for (double* coordinate : {&into.x, &into.y, &into.z}) {
      const std::optional<double> number = cursor_.number();
      if (!number) return false;
      *coordinate = *number;
      if (!std::isfinite(*number)) not_finite_.add(cursor_.offset());
    }
    return true;
  }

  bool append(const Facet& corners) {
    TriangleMesh& mesh = loaded_.mesh;
    if (mesh.triangles.size() == kMaxTriangles) {
      loaded_.faults.push_back({FaultKind::kTooLarge, "over 50 million triangles"});
      return false;
    }
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({base, base + 1, base + 2});
    return true;
  }

  /// A wrong word that is the last one was cut there, with the rest of the file.
  bool missing(const char* expected) {
    cursor_.skip_space();
    const std::size_t at = cursor_.offset();
    cursor_.word();
    if (!cursor_.at_end()) {
      loaded_.faults.push_back(
          {FaultKind::kMalformed, std::string(expected) + " is missing", 0, line_at(bytes_, at)});
    }
    return false;
  }

  void judge() {
    std::vector<Fault>& faults = loaded_.faults;
    if (not_finite_.count > 0)
      faults.push_back(fault_at(not_finite_, FaultKind::kNotFinite, bytes_));
    if (loaded_.mesh.triangles.empty()) faults.push_back({FaultKind::kEmpty});
    if (in_facet_) faults.push_back({FaultKind::kTruncated, {}, 1, line_at(bytes_, bytes_.size())});
    if (!cursor_.at_end()) {
      const Tally rest{bytes_.size() - cursor_.offset(), cursor_.offset()};
      faults.push_back(fault_at(rest, FaultKind::kTrailingBytes, bytes_));
    }
    if (endsolid_missing_ || in_facet_) faults.push_back({FaultKind::kNoEndsolid});
    if (solids_ > 1) faults.push_back({FaultKind::kSeveralSolids, {}, solids_});
    const Tally& commas = cursor_.decimal_commas();
    if (commas.count > 0) faults.push_back(fault_at(commas, FaultKind::kDecimalComma, bytes_));
  }

  std::string_view bytes_;
  TextCursor cursor_;
  LoadedMesh loaded_{.format = Format::kStlAscii};
  std::uint64_t solids_ = 0;
  Tally not_finite_;
  bool in_facet_ = false;
  bool endsolid_missing_ = false;
};

}  // namespace

LoadedMesh read_ascii_stl(std::string_view bytes) { return AsciiStlReader(bytes).run(); }

}  // namespace rigor::mesh
