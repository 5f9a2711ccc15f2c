// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Volume, center and second moments of what a closed mesh encloses.
//
// Each triangle spans a tetrahedron with one reference point; signed, the tetrahedra add up to the
// body. The sums are taken about a point near the mesh, so that a mesh a kilometer from its origin
// loses nothing, over runs of kRun facets whose sums are added with compensation at the end. Parts of a
// mesh may be summed in any order, on any number of threads, and joined in the mesh's: as long as
// each holds whole runs, the result is the same to the bit.
//
//   PolyhedronSum sum(mesh.positions.front());
//   for (const Triangle& t : mesh.triangles) sum.add(facet(mesh, t));
//   Solid solid = solid_of(sum.moments());
//   MassProperties body = of_density(solid, 7850);
//
// Formulas: with a, b, c the corners seen from the reference, D = a·(b×c), s = a+b+c: volume D/6, first
// moment D s/24, second moment D (aaᵀ+bbᵀ+ccᵀ+ssᵀ)/120 (J. Blow, A. J. Binstock, "How to find the
// inertia tensor (or other mass properties) of a 3D solid body represented by a triangle mesh", 2004;
// F. Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia tensor", 2005).

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <rigor/mass/shapes.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mass {

/// Of the enclosed body at density 1, about `reference`.
struct PolyhedronMoments {
  model::Vector3 reference;  ///< m
  double volume = 0;         ///< m³; negative when the mesh is wound inside out
  model::Vector3 first;      ///< ∫ (p - reference) dV, m⁴
  /// ∫ (p - reference)(p - reference)ᵀ dV, m⁵: xx, xy, xz, yy, yz, zz.
  std::array<double, 6> second{};
  /// m²; NaN after a scale of unequal factors, as it does not follow from these.
  double area = 0;
  /// Σ of the triangles' area vectors, m²: zero for a closed mesh, and how much an open one's volume
  /// depends on the reference.
  model::Vector3 area_vector;

  bool operator==(const PolyhedronMoments&) const = default;
};

/// Adds up facets. Two sums about the same reference can be joined.
class PolyhedronSum {
 public:
  /// Facets added plainly before the compensated addition takes over: rounding of kRun equal terms
  /// is 1e-13 of them at most, and a million facets leave a thousand runs.
  static constexpr std::size_t kRun = 1024;

  explicit PolyhedronSum(const model::Vector3& reference) : reference_(reference) {}

  void add(const mesh::Facet& facet);
  /// As if `later`'s facets had been added after this one's, with a run ending in between.
  void join(const PolyhedronSum& later);

  PolyhedronMoments moments() const;

 private:
  static constexpr std::size_t kTerms = 14;
  using Terms = std::array<double, kTerms>;

  model::Vector3 reference_;
  Terms run_{};
  std::size_t in_run_ = 0;
  std::vector<Terms> runs_;  // full ones, in the mesh's order
};

PolyhedronMoments moments_of(const mesh::TriangleMesh& mesh);

/// The same body with its coordinates multiplied by `scale`, axis by axis; a mirroring scale does not
/// turn the mesh inside out, since its winding is mirrored too.
PolyhedronMoments scaled(const PolyhedronMoments& moments, const model::Vector3& scale);

/// The same body with the mesh's winding swapped.
PolyhedronMoments inverted(const PolyhedronMoments& moments);

/// The center of volume, in the mesh's frame. The volume must not be zero.
inline model::Vector3 centroid(const PolyhedronMoments& moments) {
  return moments.reference + (1 / moments.volume) * moments.first;
}

/// The enclosed body as a solid, in the mesh's frame. The volume must be positive.
Solid solid_of(const PolyhedronMoments& moments);

}  // namespace rigor::mass
