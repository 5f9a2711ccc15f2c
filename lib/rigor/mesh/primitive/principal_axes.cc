// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/primitive/principal_axes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rigor::mesh {
namespace {

using model::Matrix3;
using Coordinates = std::array<double, 3>;

/// Jacobi's method converges quadratically: three sweeps suffice nearly always.
constexpr int kMaxSweeps = 32;

Coordinates row(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Turns the plane of axes p and q so that the entry there becomes zero (G. H. Golub, C. F. Van Loan,
/// "Matrix Computations", 8.5).
void rotate_away(Matrix3& m, Matrix3& vectors, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double tau = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
  const double c = 1 / std::sqrt(1 + t * t);
  const double s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[k][p];
    m[k][p] = c * a - s * m[k][q];
    m[k][q] = s * a + c * m[k][q];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[p][k];
    m[p][k] = c * a - s * m[q][k];
    m[q][k] = s * a + c * m[q][k];
    const double b = vectors[p][k];
    vectors[p][k] = c * b - s * vectors[q][k];
    vectors[q][k] = s * b + c * vectors[q][k];
  }
}

}  // namespace

Enclosed enclosed(const TriangleMesh& mesh) {
  Enclosed result;
  if (mesh.positions.empty()) return result;
  const Vector3 origin = mesh.positions.front();
  Vector3 first;
  Matrix3 second{};
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    const std::array<Vector3, 3> v = {f[0] - origin, f[1] - origin, f[2] - origin};
    const Vector3 s = v[0] + v[1] + v[2];
    const double d = dot(v[0], cross(v[1], v[2]));
    result.volume += d / 6;
    first = first + (d / 24) * s;
    for (const Coordinates& r : {row(v[0]), row(v[1]), row(v[2]), row(s)}) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) second[i][j] += d / 120 * r[i] * r[j];
      }
    }
  }
  if (result.volume == 0) return result;
  const Vector3 offset = (1 / result.volume) * first;
  const Coordinates r = row(offset);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      result.spread[i][j] = second[i][j] - result.volume * r[i] * r[j];
  }
  result.center = origin + offset;
  return result;
}

double enclosed_volume(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return 0;
  const Vector3 origin = mesh.positions.front();
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Facet f = facet(mesh, t);
    sum += dot(f[0] - origin, cross(f[1] - origin, f[2] - origin));
  }
  return sum / 6;
}

std::array<Vector3, 3> principal_axes(const model::Matrix3& symmetric) {
  Matrix3 m = symmetric;
  Matrix3 vectors = {Coordinates{1, 0, 0}, Coordinates{0, 1, 0}, Coordinates{0, 0, 1}};
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    rotate_away(m, vectors, 0, 1);
    rotate_away(m, vectors, 0, 2);
    rotate_away(m, vectors, 1, 2);
  }
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&m](std::size_t a, std::size_t b) { return m[a][a] > m[b][b]; });
  std::array<Vector3, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const Coordinates& r = vectors[order[i]];
    axes[i] = {r[0], r[1], r[2]};
  }
  return axes;
}

}  // namespace rigor::mesh
