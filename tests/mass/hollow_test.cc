// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Hollow shapes against the plain subtraction of textbook formulas with fifty digits, where nothing is
// lost even for the thinnest wall, and against a quadrature over slices.

#include <rigor/mass/hollow.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "mass/quadrature.h"

namespace rigor::mass {
namespace {

using test::expect_close;
using test::kPi;
using test::stacked;
using Real = boost::multiprecision::cpp_bin_float_50;

/// A solid of even density in fifty digits: its second moments are about its own center, which is on z.
struct Precise {
  Real volume, z, xx, yy, zz;
};

Solid difference(const Precise& a, const Precise& b) {
  const Real volume = a.volume - b.volume;
  const Real z = (a.volume * a.z - b.volume * b.z) / volume;
  const Real xx = (a.volume * a.xx - b.volume * b.xx) / volume;
  const Real yy = (a.volume * a.yy - b.volume * b.yy) / volume;
  const Real zz = (a.volume * (a.zz + a.z * a.z) - b.volume * (b.zz + b.z * b.z)) / volume - z * z;
  const auto plain = [](const Real& value) { return static_cast<double>(value); };
  return {plain(kPi * volume),
          {0, 0, plain(z)},
          {plain(yy + zz), 0, 0, plain(xx + zz), 0, plain(xx + yy)}};
}

// Volumes are in units of π m³.
Precise precise_box(const Real& x, const Real& y, const Real& z) {
  return {x * y * z / kPi, 0, x * x / 12, y * y / 12, z * z / 12};
}
Precise precise_ellipsoid(const Real& a, const Real& b, const Real& c) {
  return {a * b * c * 4 / 3, 0, a * a / 5, b * b / 5, c * c / 5};
}
Precise precise_cylinder(const Real& r, const Real& l) {
  return {r * r * l, 0, r * r / 4, r * r / 4, l * l / 12};
}
Precise precise_capsule(const Real& r, const Real& l) {
  const Real tube = r * r * l;
  const Real ball = r * r * r * 4 / 3;
  const Real volume = tube + ball;
  const Real across = (tube * r * r / 4 + ball * r * r / 5) / volume;
  // A half ball's center is at 3r/8, its own moment r²/5 - (3r/8)².
  const Real center = l / 2 + r * 3 / 8;
  const Real along =
      (tube * l * l / 12 + ball * (r * r / 5 - r * r * 9 / 64 + center * center)) / volume;
  return {volume, 0, across, across, along};
}
Precise precise_cone(const Real& r, const Real& h, const Real& base) {
  return {r * r * h / 3, base + h / 4, r * r * 3 / 20, r * r * 3 / 20, h * h * 3 / 80};
}

// The walls: from thick to a millionth of the size.
constexpr double kWalls[] = {0.05, 0.01, 1e-3, 1e-5, 1e-7};

// Rounding of a few dozen operations, none of which cancels.
constexpr double kExact = 2e-15;

TEST(Hollow, AsExactForThinWallsAsForThickOnes) {
  for (const double wall : kWalls) {
    SCOPED_TRACE(wall);
    const Real t = wall;
    expect_close(
        hollow_box({0.3, 0.4, 0.5}, wall),
        difference(precise_box(0.3, 0.4, 0.5), precise_box(0.3 - 2 * t, 0.4 - 2 * t, 0.5 - 2 * t)),
        kExact);
    expect_close(
        hollow_sphere(0.2, wall),
        difference(precise_ellipsoid(0.2, 0.2, 0.2), precise_ellipsoid(0.2 - t, 0.2 - t, 0.2 - t)),
        kExact);
    expect_close(
        hollow_ellipsoid({0.1, 0.2, 0.3}, wall),
        difference(precise_ellipsoid(0.1, 0.2, 0.3), precise_ellipsoid(0.1 - t, 0.2 - t, 0.3 - t)),
        kExact);
    expect_close(hollow_cylinder(0.1, 0.7, wall),
                 difference(precise_cylinder(0.1, 0.7), precise_cylinder(0.1 - t, 0.7 - 2 * t)),
                 kExact);
    expect_close(hollow_capsule(0.1, 0.7, wall),
                 difference(precise_capsule(0.1, 0.7), precise_capsule(0.1 - t, 0.7)), kExact);
  }
}

/// The inner cone by its three lines: base and side moved inward by the wall.
Solid cone_by_lines(double radius, double length, double wall) {
  const Real r = radius, h = length, t = wall;
  const Real slant = sqrt(r * r + h * h);
  const Real base = -h / 2 + t;
  // The side is where ρ h + (z - h/2) r = 0; its inner parallel has -t·slant on the right.
  const Real apex = h / 2 - t * slant / r;
  const Real inner_radius = (-t * slant - (base - h / 2) * r) / h;
  return difference(precise_cone(r, h, -h / 2), precise_cone(inner_radius, apex - base, base));
}

TEST(Hollow, ConesOfAllAngles) {
  for (const double wall : kWalls) {
    SCOPED_TRACE(wall);
    for (const double length : {0.3, 0.5, 2.0, 20.0}) {
      expect_close(hollow_cone(0.2, length, 0.5 * wall), cone_by_lines(0.2, length, 0.5 * wall),
                   10 * kExact);  // the square of the center's height is subtracted
    }
  }
}

TEST(Hollow, Quadrature) {
  constexpr double kClose = 1e-13;
  const double t = 0.03;
  expect_close(hollow_box({0.3, 0.4, 0.5}, t),
               stacked({-0.25, -0.22, 0.22, 0.25},
                       [](double z) {
                         const auto all = test::rectangle(0.3, 0.4);
                         return std::abs(z) > 0.22 ? all : all - test::rectangle(0.24, 0.34);
                       }),
               kClose);
  expect_close(hollow_sphere(0.2, t),
               stacked({-0.2, -0.17, 0.17, 0.2},
                       [](double z) { return test::ball(0.2, z) - test::ball(0.17, z); }),
               kClose);
  expect_close(hollow_cylinder(0.1, 0.7, t),
               stacked({-0.35, -0.32, 0.32, 0.35},
                       [](double z) {
                         const auto all = test::circle(0.1);
                         return std::abs(z) > 0.32 ? all : all - test::circle(0.07);
                       }),
               kClose);
  expect_close(hollow_capsule(0.1, 0.7, t),
               stacked({-0.45, -0.42, -0.35, 0.35, 0.42, 0.45},
                       [](double z) {
                         const double beyond = std::max(0.0, std::abs(z) - 0.35);
                         return test::ball(0.1, beyond) - test::ball(0.07, beyond);
                       }),
               kClose);
  const auto in_ellipsoid = [](double a, double b, double c, double z) {
    const double share = std::sqrt(std::max(0.0, 1 - z * z / (c * c)));
    return test::ellipse(a * share, b * share);
  };
  expect_close(hollow_ellipsoid({0.1, 0.2, 0.3}, t),
               stacked({-0.3, -0.27, 0.27, 0.3},
                       [&](double z) {
                         return in_ellipsoid(0.1, 0.2, 0.3, z) - in_ellipsoid(0.07, 0.17, 0.27, z);
                       }),
               kClose);
}

TEST(Hollow, ConeQuadrature) {
  // Radius 0.3, height 0.4: the slant is 0.5 and the inradius 0.15. Of a wall of 0.03 the inner apex
  // is 0.03·0.5/0.3 = 0.05 below the outer one, and the inner radius 0.8·0.3.
  expect_close(hollow_cone(0.3, 0.4, 0.03),
               stacked({-0.2, -0.17, 0.15, 0.2},
                       [](double z) {
                         const double outer = 0.3 * (0.2 - z) / 0.4;
                         const double inner = 0.24 * (0.15 - z) / 0.32;
                         const auto all = test::circle(outer);
                         return z < -0.17 || z > 0.15 ? all : all - test::circle(inner);
                       }),
               1e-13);
}

TEST(Hollow, ThinSphereIsAShell) {
  // Of a shell, 2/3 r²; the first correction is -t/r of it.
  const double t = 1e-8;
  EXPECT_NEAR(hollow_sphere(1, t).unit_inertia.ixx, 2.0 / 3 * (1 - t), 1e-15);
  EXPECT_NEAR(hollow_sphere(1, t).volume, 4 * kPi * t * (1 - t), 1e-22);
}

TEST(Hollow, WallAndFillingAreTheSolid) {
  const MassProperties wall = of_density(hollow_cylinder(0.2, 0.5, 0.04), 1000);
  const MassProperties filling = of_density(cylinder(0.16, 0.42), 1000);
  const MassProperties whole = of_density(cylinder(0.2, 0.5), 1000);
  EXPECT_NEAR(add(wall, filling).mass, whole.mass, 1e-12 * whole.mass);
  EXPECT_NEAR(add(wall, filling).about_com.ixx, whole.about_com.ixx, 1e-12);
}

TEST(Hollow, AWallThatFillsIsSolid) {
  constexpr double kRounding = 1e-15;
  expect_close(hollow_box({0.3, 0.4, 0.5}, 0.15), box({0.3, 0.4, 0.5}), kRounding);
  expect_close(hollow_sphere(0.2, 0.2), sphere(0.2), kRounding);
  expect_close(hollow_sphere(0.2, 7), sphere(0.2), kRounding);
  expect_close(hollow_cylinder(0.2, 0.1, 0.06), cylinder(0.2, 0.1), kRounding);
  expect_close(hollow_capsule(0.2, 0.1, 0.2), capsule(0.2, 0.1), kRounding);
  expect_close(hollow_cone(0.3, 0.4, 0.15), cone(0.3, 0.4), kRounding);
  expect_close(hollow_ellipsoid({0.1, 0.2, 0.3}, 0.1), ellipsoid({0.1, 0.2, 0.3}), kRounding);
}

TEST(Hollow, OfAShape) {
  model::Cylinder shape;
  shape.radius.value = 1;
  shape.length.value = 2;
  ASSERT_TRUE(hollow(shape, 0.1));
  EXPECT_EQ(hollow(shape, 0.1)->volume, hollow_cylinder(1, 2, 0.1).volume);
  for (const double wall : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(hollow(shape, wall)) << wall;
  }
  shape.radius.value = -1;
  EXPECT_FALSE(hollow(shape, 0.1));
  EXPECT_FALSE(hollow(model::Mesh{}, 0.1));
  EXPECT_FALSE(hollow(model::NoShape{}, 0.1));
}

}  // namespace
}  // namespace rigor::mass
