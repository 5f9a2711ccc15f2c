// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <meshoptimizer.h>

#include <rigor/mesh/reduce.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {

TriangleMesh reduced_loosely(const TriangleMesh& mesh, std::uint64_t triangles) {
  const Weld welded = weld(mesh.positions);
  std::vector<Vector3> places;
  places.reserve(welded.places());
  for (const std::uint32_t first : welded.first) places.push_back(mesh.positions[first]);
  std::vector<unsigned int> index;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) index.push_back(welded.place[corner]);
  }
  if (index.empty()) return {};
  const Bounds bounds = bounds_of(places);
  const Vector3 size = bounds.max - bounds.min;
  const double side = std::max({size.x, size.y, size.z, 1e-300});
  std::vector<std::array<float, 3>> points;
  points.reserve(places.size());
  for (const Vector3& p : places) {
    const Vector3 scaled = (1 / side) * (p - bounds.min);
    points.push_back(
        {static_cast<float>(scaled.x), static_cast<float>(scaled.y), static_cast<float>(scaled.z)});
  }
  constexpr float kWholeSide = 1;  // an error as large as the mesh is taken
  const std::size_t target = std::min<std::size_t>(3 * triangles, index.size());
  std::vector<unsigned int> left(index.size());
  left.resize(meshopt_simplifySloppy(left.data(), index.data(), index.size(), points.front().data(),
                                     points.size(), sizeof(points.front()), target, kWholeSide,
                                     nullptr));
  std::vector<Triangle> faces;
  for (std::size_t i = 0; i + 2 < left.size(); i += 3)
    faces.push_back({left[i], left[i + 1], left[i + 2]});
  return compacted(places, std::move(faces));
}

}  // namespace rigor::mesh
