// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Volume, center and inertia by summing slices across z: knows what a slice is, and nothing of the
// closed forms. Between two breaks a slice's moments are polynomials in z of a degree of six at
// most, for which five Gauss points are exact.

#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/shapes.h>

namespace rigor::test {

using mass::Solid;

inline constexpr double kPi = 3.14159265358979323846;

/// ∫ dA, ∫ x² dA and ∫ y² dA of a slice.
struct Slice {
  double area = 0, xx = 0, yy = 0;
};

inline Slice operator-(const Slice& a, const Slice& b) {
  return {a.area - b.area, a.xx - b.xx, a.yy - b.yy};
}

inline Slice ellipse(double a, double b) {
  const double area = kPi * a * b;
  return {area, area * a * a / 4, area * b * b / 4};
}

inline Slice circle(double radius) { return ellipse(radius, radius); }

/// Of a ball, at height z above its center.
inline Slice ball(double radius, double z) {
  return circle(std::sqrt(std::max(0.0, radius * radius - z * z)));
}

inline Slice rectangle(double x, double y) {
  return {x * y, x * y * x * x / 12, x * y * y * y / 12};
}

/// `breaks` ascending: where a slice's formula changes, the ends included.
inline Solid stacked(const std::vector<double>& breaks, const std::function<Slice(double)>& slice) {
  const double near = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
  const double far = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  const double root = 13 * std::sqrt(70.0);
  const std::array<double, 5> points{-far, -near, 0, near, far};
  const std::array<double, 5> weights{(322 - root) / 900, (322 + root) / 900, 128.0 / 225,
                                      (322 + root) / 900, (322 - root) / 900};
  double volume = 0, z1 = 0, xx = 0, yy = 0, zz = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double half = (breaks[i + 1] - breaks[i]) / 2;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double z = (breaks[i] + breaks[i + 1]) / 2 + half * points[k];
      const Slice at = slice(z);
      const double weight = half * weights[k];
      volume += weight * at.area;
      xx += weight * at.xx;
      yy += weight * at.yy;
      z1 += weight * at.area * z;
      zz += weight * at.area * z * z;
    }
  }
  const double com = z1 / volume;
  zz = zz / volume - com * com;
  return {volume, {0, 0, com}, {yy / volume + zz, 0, 0, xx / volume + zz, 0, (xx + yy) / volume}};
}

/// The center's error counts against the radius of gyration.
inline void expect_close(const Solid& a, const Solid& b, double relative) {
  const double size = std::sqrt(trace(b.unit_inertia));
  EXPECT_NEAR(a.volume, b.volume, relative * b.volume);
  EXPECT_NEAR(model::length(a.com - b.com), 0, relative * size);
  EXPECT_NEAR(a.unit_inertia.ixx, b.unit_inertia.ixx, relative * b.unit_inertia.ixx);
  EXPECT_NEAR(a.unit_inertia.iyy, b.unit_inertia.iyy, relative * b.unit_inertia.iyy);
  EXPECT_NEAR(a.unit_inertia.izz, b.unit_inertia.izz, relative * b.unit_inertia.izz);
  EXPECT_NEAR(a.unit_inertia.ixy, b.unit_inertia.ixy, relative * size * size);
  EXPECT_NEAR(a.unit_inertia.ixz, b.unit_inertia.ixz, relative * size * size);
  EXPECT_NEAR(a.unit_inertia.iyz, b.unit_inertia.iyz, relative * size * size);
}

}  // namespace rigor::test
