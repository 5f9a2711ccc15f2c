// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/pyramids.h>

#include <cmath>

namespace rigor::mass {
namespace {

using model::Vector3;

/// The middle of the surface: centroids of the triangles by their areas.
std::optional<Vector3> middle_of_surface(const mesh::TriangleMesh& mesh) {
  Vector3 sum;
  double area = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double own = length(cross(b - a, c - a)) / 2;
    sum = sum + (own / 3) * (a + b + c);
    area += own;
  }
  if (!(area > 0)) return std::nullopt;
  return 1 / area * sum;
}

/// The formula of polyhedron.h, with |D| for D where all count as positive.
PolyhedronMoments about_apex(const mesh::TriangleMesh& mesh, const Vector3& apex,
                             PyramidSigns signs) {
  PolyhedronMoments moments;
  moments.reference = apex;
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vector3 a = mesh.positions[t[0]] - apex, b = mesh.positions[t[1]] - apex,
                  c = mesh.positions[t[2]] - apex;
    const double wound = dot(a, cross(b, c));
    const double d = signs == PyramidSigns::kPositive ? std::abs(wound) : wound;
    const Vector3 s = a + b + c;
    moments.volume += d / 6;
    moments.first = moments.first + (d / 24) * s;
    const auto product = [&](double Vector3::*i, double Vector3::*k) {
      return d / 120 * (a.*i * a.*k + b.*i * b.*k + c.*i * c.*k + s.*i * s.*k);
    };
    moments.second[0] += product(&Vector3::x, &Vector3::x);
    moments.second[1] += product(&Vector3::x, &Vector3::y);
    moments.second[2] += product(&Vector3::x, &Vector3::z);
    moments.second[3] += product(&Vector3::y, &Vector3::y);
    moments.second[4] += product(&Vector3::y, &Vector3::z);
    moments.second[5] += product(&Vector3::z, &Vector3::z);
  }
  return moments;
}

}  // namespace

std::optional<PolyhedronMoments> pyramids_of(const mesh::TriangleMesh& mesh, PyramidSigns signs) {
  const auto middle = middle_of_surface(mesh);
  if (!middle) return std::nullopt;
  const PolyhedronMoments from_middle = about_apex(mesh, *middle, signs);
  if (!(from_middle.volume > 0)) return std::nullopt;
  // MuJoCo moves the mesh to this center of mass, and weighs pyramids from there without moving it again.
  const Vector3 com = *middle + 1 / from_middle.volume * from_middle.first;
  PolyhedronMoments moments = about_apex(mesh, com, signs);
  moments.first = {};
  if (!(moments.volume > 0)) return std::nullopt;
  return moments;
}

}  // namespace rigor::mass
