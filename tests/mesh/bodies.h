// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Sound closed meshes, and what topology counts of a mesh by name.

#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <rigor/mesh/topology/topology.h>

#include "support/meshes.h"

namespace rigor::mesh {

using test::box_mesh;
using test::joined;
using test::torus_mesh;
using test::turned;

/// A ball of `n` meridians and `m` - 1 parallels between its poles: n (m - 1) + 2 vertices.
inline TriangleMesh ball_mesh(double radius, unsigned n, unsigned m) {
  constexpr double kPi = 3.141592653589793;
  TriangleMesh mesh;
  for (unsigned j = 1; j < m; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      const double u = 2 * kPi * i / n;
      const double v = kPi * j / m;
      mesh.positions.push_back({radius * std::sin(v) * std::cos(u),
                                radius * std::sin(v) * std::sin(u), radius * std::cos(v)});
    }
  }
  const std::uint32_t top = n * (m - 1);
  mesh.positions.push_back({0, 0, radius});
  mesh.positions.push_back({0, 0, -radius});
  const auto at = [n](unsigned j, unsigned i) { return (j - 1) * n + i % n; };
  for (unsigned i = 0; i < n; ++i) {
    mesh.triangles.push_back({top, at(1, i), at(1, i + 1)});
    mesh.triangles.push_back({top + 1, at(m - 1, i + 1), at(m - 1, i)});
    for (unsigned j = 1; j + 1 < m; ++j) {
      mesh.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      mesh.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return mesh;
}

/// An L of two bars, three units long and wide, one thick, as a prism of height 2: its volume is 10.
inline TriangleMesh bracket_mesh() {
  TriangleMesh mesh;
  for (const double z : {0.0, 2.0}) {
    for (const auto& [x, y] : {std::pair(0, 0), {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}) {
      mesh.positions.push_back({double(x), double(y), z});
    }
  }
  const std::vector<Triangle> l = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (const Triangle& t : l) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    mesh.triangles.push_back({i, next, next + 6});
    mesh.triangles.push_back({i, next + 6, i + 6});
  }
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Vector3& p : mesh.positions) p = p + by;
  return mesh;
}

struct Body {
  std::string name;
  TriangleMesh mesh;
  std::int64_t euler;
  std::uint64_t components;
};

inline std::vector<Body> bodies() {
  const TriangleMesh several =
      joined(joined(torus_mesh(2, 0.6, 20, 12), moved(bracket_mesh(), {9, 0, 0})),
             moved(ball_mesh(1, 16, 8), {0, 9, 0}));
  return {{"ball", ball_mesh(1, 16, 9), 2, 1},
          {"torus", torus_mesh(2, 0.6, 24, 16), 0, 1},
          {"box", box_mesh({1, 2, 3}), 2, 1},
          {"bracket", bracket_mesh(), 2, 1},
          {"several", several, 0 + 2 + 2, 3}};
}

/// All that is counted, by name, so that a failure tells what differs.
inline std::vector<std::pair<std::string, std::int64_t>> counts(const Topology& t) {
  const auto n = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
  return {{"vertices", n(t.vertices)},
          {"edges", n(t.edges)},
          {"triangles", n(t.triangles)},
          {"boundary", n(t.boundary_edges)},
          {"nonmanifold edges", n(t.nonmanifold_edges)},
          {"inconsistent", n(t.inconsistent_edges)},
          {"nonmanifold vertices", n(t.nonmanifold_vertices)},
          {"degenerate", n(t.degenerate)},
          {"zero area", n(t.zero_area)},
          {"slivers", n(t.slivers)},
          {"duplicates", n(t.duplicates)},
          {"unreferenced", n(t.unreferenced)},
          {"loops", n(t.boundary.loops)},
          {"longest loop", n(t.boundary.longest_edges)},
          {"components", n(t.components)},
          {"inverted", n(t.inverted)},
          {"cavities", n(t.cavities)},
          {"doubled", n(t.doubled)},
          {"not nested", n(t.not_nested)}};
}

}  // namespace rigor::mesh
