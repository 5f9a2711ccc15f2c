// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be wrong with a mesh at one of its triangles, edges or vertices, and where it is.
//
//   DefectTally tally;
//   tally.add(Defect::kSliver, face, [&] { return middle_of(face); });
//   tally.count(Defect::kSliver);

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

enum class Defect : std::uint8_t {
  kBoundaryEdge,       ///< of one triangle
  kNonmanifoldEdge,    ///< of more than two triangles
  kInconsistentEdge,   ///< of two triangles that run the same way along it
  kNonmanifoldVertex,  ///< the triangles round it fall into fans that share nothing but it
  kDegenerateFace,     ///< two corners in one place
  kZeroAreaFace,       ///< three places on one line
  kSliver,             ///< thinner than a thousandth of its longest edge, but not of zero area
  kDuplicateFace,      ///< the same three places as a face before it, in either orientation
  kUnreferencedVertex  ///< no triangle uses it
};

inline constexpr std::size_t kDefects = 9;

/// So many of each are reported with their place.
inline constexpr std::uint64_t kMaxExamples = 8;

/// The middle of an edge or triangle, which is named by a triangle; or a vertex, named by a position.
struct Example {
  Defect defect;
  std::uint64_t index = 0;  ///< into the mesh's triangles or positions, from 0
  Vector3 at;
};

inline Vector3 middle(const Facet& f) { return (1.0 / 3) * (f[0] + f[1] + f[2]); }

class DefectTally {
 public:
  /// `where` gives the place, and is asked for no more than the first few.
  template <class Where>
  void add(Defect defect, std::uint64_t index, const Where& where) {
    if (counts_[static_cast<std::size_t>(defect)]++ < kMaxExamples) {
      examples_.push_back({defect, index, where()});
    }
  }

  std::uint64_t count(Defect defect) const { return counts_[static_cast<std::size_t>(defect)]; }
  const std::vector<Example>& examples() const { return examples_; }

 private:
  std::array<std::uint64_t, kDefects> counts_{};
  std::vector<Example> examples_;
};

}  // namespace rigor::mesh
