// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/polyhedron.h>

#include <cmath>
#include <limits>

namespace rigor::mass {
namespace {

using model::Vector3;

/// A sum and what it lost to rounding (A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur
/// Summation endlicher Summen", 1974).
struct Compensated {
  double sum = 0;
  double lost = 0;

  void add(double term) {
    const double next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
};

// pose.h's operators are calls, which would be most of the time spent on a facet.
inline Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vector3 times(const Vector3& a, const Vector3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace

void PolyhedronSum::add(const mesh::Facet& facet) {
  const Vector3 a = minus(facet[0], reference_);
  const Vector3 b = minus(facet[1], reference_);
  const Vector3 c = minus(facet[2], reference_);
  // a·(b×c) as a·((b-a)×(c-a)): of a small facet far from the reference, b×c would be rounding only.
  const Vector3 u = minus(facet[1], facet[0]);
  const Vector3 v = minus(facet[2], facet[0]);
  const Vector3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double D = a.x * n.x + a.y * n.y + a.z * n.z;
  const Vector3 s{a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z};
  run_[0] += D;
  run_[1] += D * s.x;
  run_[2] += D * s.y;
  run_[3] += D * s.z;
  run_[4] += D * (a.x * a.x + b.x * b.x + c.x * c.x + s.x * s.x);
  run_[5] += D * (a.x * a.y + b.x * b.y + c.x * c.y + s.x * s.y);
  run_[6] += D * (a.x * a.z + b.x * b.z + c.x * c.z + s.x * s.z);
  run_[7] += D * (a.y * a.y + b.y * b.y + c.y * c.y + s.y * s.y);
  run_[8] += D * (a.y * a.z + b.y * b.z + c.y * c.z + s.y * s.z);
  run_[9] += D * (a.z * a.z + b.z * b.z + c.z * c.z + s.z * s.z);
  run_[10] += std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  run_[11] += n.x;
  run_[12] += n.y;
  run_[13] += n.z;
  if (++in_run_ < kRun) return;
  runs_.push_back(run_);
  run_ = {};
  in_run_ = 0;
}

void PolyhedronSum::join(const PolyhedronSum& later) {
  if (in_run_ > 0) runs_.push_back(run_);
  runs_.insert(runs_.end(), later.runs_.begin(), later.runs_.end());
  run_ = later.run_;
  in_run_ = later.in_run_;
}

PolyhedronMoments PolyhedronSum::moments() const {
  Terms t{};
  for (std::size_t i = 0; i < kTerms; ++i) {
    Compensated total;
    for (const Terms& run : runs_) total.add(run[i]);
    total.add(run_[i]);
    t[i] = total.sum + total.lost;
  }
  return {.reference = reference_,
          .volume = t[0] / 6,
          .first = {t[1] / 24, t[2] / 24, t[3] / 24},
          .second = {t[4] / 120, t[5] / 120, t[6] / 120, t[7] / 120, t[8] / 120, t[9] / 120},
          .area = t[10] / 2,
          .area_vector = {t[11] / 2, t[12] / 2, t[13] / 2}};
}

PolyhedronMoments moments_of(const mesh::TriangleMesh& mesh) {
  const mesh::Bounds bounds = mesh::bounds_of(mesh.positions);
  PolyhedronSum sum(mesh.positions.empty() ? Vector3{} : 0.5 * (bounds.min + bounds.max));
  for (const mesh::Triangle& t : mesh.triangles) sum.add(mesh::facet(mesh, t));
  return sum.moments();
}

PolyhedronMoments scaled(const PolyhedronMoments& moments, const Vector3& scale) {
  const auto& [x, y, z] = scale;
  const double grow = std::abs(x * y * z);
  const double turn = x * y * z < 0 ? -1 : 1;
  const bool even = std::abs(x) == std::abs(y) && std::abs(y) == std::abs(z);
  PolyhedronMoments result{
      .reference = times(scale, moments.reference),
      .volume = grow * moments.volume,
      .first = grow * times(scale, moments.first),
      .second = {x * x, x * y, x * z, y * y, y * z, z * z},
      .area = even ? x * x * moments.area : std::numeric_limits<double>::quiet_NaN(),
      .area_vector = turn * times({y * z, x * z, x * y}, moments.area_vector)};
  for (std::size_t i = 0; i < 6; ++i) result.second[i] *= grow * moments.second[i];
  return result;
}

PolyhedronMoments inverted(const PolyhedronMoments& moments) {
  PolyhedronMoments result = moments;
  result.volume = -moments.volume;
  result.first = -1 * moments.first;
  for (double& entry : result.second) entry = -entry;
  result.area_vector = -1 * moments.area_vector;
  return result;
}

Solid solid_of(const PolyhedronMoments& moments) {
  const Vector3 com = (1 / moments.volume) * moments.first;
  const auto about_com = [&](std::size_t entry, double product) {
    return moments.second[entry] / moments.volume - product;
  };
  const double xx = about_com(0, com.x * com.x);
  const double yy = about_com(3, com.y * com.y);
  const double zz = about_com(5, com.z * com.z);
  return {moments.volume,
          moments.reference + com,
          {.ixx = yy + zz,
           .ixy = -about_com(1, com.x * com.y),
           .ixz = -about_com(2, com.x * com.z),
           .iyy = xx + zz,
           .iyz = -about_com(4, com.y * com.z),
           .izz = xx + yy}};
}

}  // namespace rigor::mass
