// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/sdformat_inertia.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::rules {
namespace {

using Moments = std::array<double, 3>;

/// Off-diagonal entries below this share of the largest moment are taken for none.
constexpr double kDiagonal = 1e-6;

/// What sums of moments may be short of: ten roundings of the largest moment there can be.
double allowance(const Moments& moments) {
  const double largest = 0.5 * std::abs(moments[0] + moments[1] + moments[2]);
  return 10 * std::numeric_limits<double>::epsilon() * largest;
}

double determinant_of(const mass::Inertia& t) {
  const double v0 = t.iyy * t.izz - t.iyz * t.iyz;
  const double v1 = -(t.ixy * t.izz - t.ixz * t.iyz);
  const double v2 = t.ixy * t.iyz - t.ixz * t.iyy;
  return t.ixx * v0 + t.ixy * v1 + t.ixz * v2;
}

bool nearly_positive(double mass, const mass::Inertia& t) {
  const double slack = allowance({t.ixx, t.iyy, t.izz});
  return mass >= 0 && t.ixx + slack >= 0 && t.ixx * t.iyy - t.ixy * t.ixy + slack >= 0 &&
         determinant_of(t) + slack >= 0;
}

/// M. Kronenburg, "A method for fast diagonalization of a 2x2 or 3x3 real symmetric matrix" (2013).
Moments kronenburg_moments(const mass::Inertia& t) {
  const double near = kDiagonal * std::max({t.ixx, t.iyy, t.izz});
  const auto small = [near](double entry) { return std::abs(entry) <= near; };
  if (small(t.ixy) && small(t.ixz) && small(t.iyz)) return {t.ixx, t.iyy, t.izz};
  const double b = t.ixx + t.iyy + t.izz;
  const double c =
      t.ixx * t.iyy - t.ixy * t.ixy + t.ixx * t.izz - t.ixz * t.ixz + t.iyy * t.izz - t.iyz * t.iyz;
  const double d = t.ixx * (t.iyz * t.iyz) + t.iyy * (t.ixz * t.ixz) + t.izz * (t.ixy * t.ixy) -
                   t.ixx * t.iyy * t.izz - 2 * t.ixy * t.ixz * t.iyz;
  const double p = b * b - 3 * c;
  if (p < near * near) return {b / 3, b / 3, b / 3};
  const double q = 2 * std::pow(b, 3) - 9 * b * c - 27 * d;
  const double delta = std::acos(std::clamp(0.5 * q / std::pow(p, 1.5), -1.0, 1.0));
  const double reach = 2 * std::sqrt(p);
  const auto moment = [&](double turn) { return (b + reach * std::cos((delta + turn) / 3)) / 3; };
  Moments moments{moment(0), moment(2 * std::numbers::pi), moment(-2 * std::numbers::pi)};
  std::sort(moments.begin(), moments.end());
  return moments;
}

bool possible_moments(const Moments& m) {
  const double slack = allowance(m);
  return m[0] + slack >= 0 && m[1] + slack >= 0 && m[2] + slack >= 0 &&
         m[0] + m[1] + slack >= m[2] && m[1] + m[2] + slack >= m[0] && m[2] + m[0] + slack >= m[1];
}

}  // namespace

bool sdformat_takes(double mass, const mass::Inertia& tensor) {
  return nearly_positive(mass, tensor) && possible_moments(kronenburg_moments(tensor));
}

}  // namespace rigor::rules
