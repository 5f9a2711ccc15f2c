// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The closed forms against numbers worked out by hand and against a quadrature that knows nothing
// of them: a midpoint rule over slices across z, each an ellipse whose own moments are elementary.

#include <rigor/mass/shapes.h>

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Half widths of a slice at z.
struct Slice {
  double a, b;
};

/// Stacks slices from z = -h to h; ∫x² over an ellipse is πab·a²/4.
Solid quadrature(double h, const std::function<Slice(double)>& slice) {
  constexpr int kSlices = 200'000;
  double volume = 0, z1 = 0, xx = 0, yy = 0, zz = 0;
  const double dz = 2 * h / kSlices;
  for (int i = 0; i < kSlices; ++i) {
    const double z = -h + (i + 0.5) * dz;
    const auto [a, b] = slice(z);
    const double dV = kPi * a * b * dz;
    volume += dV;
    z1 += z * dV;
    xx += a * a / 4 * dV;
    yy += b * b / 4 * dV;
    zz += z * z * dV;
  }
  const double com = z1 / volume;
  zz = zz / volume - com * com;
  xx /= volume;
  yy /= volume;
  return {volume, {0, 0, com}, {yy + zz, 0, 0, xx + zz, 0, xx + yy}};
}

void expect_close(const Solid& a, const Solid& b) {
  constexpr double kRelative = 1e-8;  // the midpoint rule at edges where a slice has a root
  EXPECT_NEAR(a.volume, b.volume, kRelative * b.volume);
  EXPECT_NEAR(a.com.z, b.com.z, kRelative);
  EXPECT_NEAR(a.unit_inertia.ixx, b.unit_inertia.ixx, kRelative * b.unit_inertia.ixx);
  EXPECT_NEAR(a.unit_inertia.iyy, b.unit_inertia.iyy, kRelative * b.unit_inertia.iyy);
  EXPECT_NEAR(a.unit_inertia.izz, b.unit_inertia.izz, kRelative * b.unit_inertia.izz);
}

double circle(double radius, double z) { return std::sqrt(std::max(0.0, radius * radius - z * z)); }

TEST(Shapes, BoxByHand) {
  const Solid solid = box({1, 2, 3});
  EXPECT_EQ(solid.volume, 6);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 13.0 / 12);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.iyy, 10.0 / 12);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 5.0 / 12);
}

TEST(Shapes, SphereByHand) {
  const Solid solid = sphere(0.5);
  EXPECT_DOUBLE_EQ(solid.volume, kPi / 6);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 0.1);
}

TEST(Shapes, CylinderByHand) {
  const Solid solid = cylinder(2, 6);
  EXPECT_DOUBLE_EQ(solid.volume, 24 * kPi);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 4);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 2);
}

TEST(Shapes, Quadrature) {
  expect_close(sphere(0.3), quadrature(0.3, [](double z) {
                 const double a = circle(0.3, z);
                 return Slice{a, a};
               }));
  expect_close(cylinder(0.2, 0.9), quadrature(0.45, [](double) { return Slice{0.2, 0.2}; }));
  expect_close(capsule(0.2, 0.9), quadrature(0.65, [](double z) {
                 const double a = circle(0.2, std::max(0.0, std::abs(z) - 0.45));
                 return Slice{a, a};
               }));
  expect_close(cone(0.4, 1.2), quadrature(0.6, [](double z) {
                 const double a = 0.4 * (0.6 - z) / 1.2;
                 return Slice{a, a};
               }));
  expect_close(ellipsoid({0.3, 0.7, 1.1}), quadrature(1.1, [](double z) {
                 const double share = circle(1, z / 1.1);
                 return Slice{0.3 * share, 0.7 * share};
               }));
}

TEST(Shapes, LimitsAgree) {
  expect_close(capsule(0.3, 1e-12), sphere(0.3));
  expect_close(capsule(1e-12, 2), cylinder(1e-12, 2));
}

TEST(Shapes, SolidOfAShape) {
  model::Cone shape;
  shape.radius.value = 1;
  shape.length.value = 2;
  const auto solid = solid_of(shape);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->com, (model::Vector3{0, 0, -0.5}));
  EXPECT_DOUBLE_EQ(with_mass(*solid, 10).about_com.izz, 3);

  shape.radius.value = 0;
  EXPECT_FALSE(solid_of(shape));
  EXPECT_FALSE(solid_of(model::Mesh{}));
  EXPECT_FALSE(solid_of(model::Plane{}));
  EXPECT_FALSE(solid_of(model::NoShape{}));
}

TEST(Shapes, EverySolidIsPossible) {
  for (const Solid& solid : {box({0.01, 1, 5}), sphere(2), cylinder(1e-3, 4), cylinder(4, 1e-3),
                             capsule(0.1, 3), cone(1, 0.01), ellipsoid({1, 2, 3})}) {
    EXPECT_TRUE(judge(with_mass(solid, 7)).possible());
  }
}

}  // namespace
}  // namespace rigor::mass
