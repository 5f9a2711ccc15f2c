// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes whose facts are known in closed form, for tests.

#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>

namespace rigor::test {

using mesh::Triangle;
using mesh::TriangleMesh;
using model::Vector3;

/// Sides along the axes, centered at `center`; twelve triangles.
inline TriangleMesh box_mesh(const Vector3& size, const Vector3& center = {}) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const auto half = [](bool upper, double side) { return upper ? side / 2 : -side / 2; };
    mesh.positions.push_back(center + Vector3{half((i & 1) != 0, size.x),
                                              half((i & 2) != 0, size.y),
                                              half((i & 4) != 0, size.z)});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A grid of `n` by `m` cells closed in both directions: a torus about z.
inline TriangleMesh torus_mesh(double big, double small, unsigned n, unsigned m) {
  constexpr double kTau = 6.283185307179586;
  TriangleMesh mesh;
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < m; ++j) {
      const double u = kTau * i / n;
      const double v = kTau * j / m;
      const double r = big + small * std::cos(v);
      mesh.positions.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
    }
  }
  const auto at = [n, m](unsigned i, unsigned j) { return i % n * m + j % m; };
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A ball of 8 by 16 facets, within 2 % of its radius from a sphere but for the poles.
inline TriangleMesh faceted_ball(double radius) {
  TriangleMesh mesh;
  constexpr std::uint32_t kRows = 8, kColumns = 16;
  for (std::uint32_t i = 0; i <= kRows; ++i) {
    for (std::uint32_t j = 0; j < kColumns; ++j) {
      const double around = 2 * M_PI * j / kColumns,
                   across = i % kRows == 0 ? 0 : std::sin(M_PI * i / kRows);
      mesh.positions.push_back({radius * across * std::cos(around),
                                radius * across * std::sin(around),
                                radius * std::cos(M_PI * i / kRows)});
    }
  }
  for (std::uint32_t i = 0; i < kRows; ++i) {
    for (std::uint32_t j = 0; j < kColumns; ++j) {
      const std::uint32_t k = (j + 1) % kColumns;
      const std::uint32_t a = i * kColumns, b = a + kColumns;
      if (i + 1 < kRows) mesh.triangles.push_back({a + j, b + j, b + k});
      if (i > 0) mesh.triangles.push_back({a + j, b + k, a + k});
    }
  }
  return mesh;
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return a;
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

/// As the bytes of a binary STL.
inline std::string binary_stl(const TriangleMesh& mesh) {
  std::string out(80, ' ');
  const auto put = [&out](const void* value, std::size_t size) {
    out.append(static_cast<const char*>(value), size);
  };
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  put(&count, 4);
  for (const Triangle& t : mesh.triangles) {
    const std::array<float, 3> normal{};
    put(normal.data(), 12);
    for (const std::uint32_t corner : t) {
      const Vector3& p = mesh.positions[corner];
      const std::array<float, 3> xyz{static_cast<float>(p.x), static_cast<float>(p.y),
                                     static_cast<float>(p.z)};
      put(xyz.data(), 12);
    }
    out.append(2, '\0');
  }
  return out;
}

}  // namespace rigor::test
