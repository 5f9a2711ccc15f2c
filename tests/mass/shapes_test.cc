// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The closed forms against numbers worked out by hand and against a quadrature that knows nothing
// of them.

#include <rigor/mass/shapes.h>

#include <cmath>

#include <gtest/gtest.h>

#include "mass/quadrature.h"

namespace rigor::mass {
namespace {

using test::expect_close;
using test::kPi;
using test::stacked;

// Rounding of a few dozen operations.
constexpr double kExactShape = 1e-14;

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

TEST(Shapes, EllipsoidByHand) {
  const Solid solid = ellipsoid({1, 2, 3});
  EXPECT_DOUBLE_EQ(solid.volume, 8 * kPi);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 13.0 / 5);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.iyy, 2);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 1);
}

TEST(Shapes, ConeByHand) {
  // Radius 2, height 4: about the center of mass 3/80 (4·4 + 16).
  const Solid solid = cone(2, 4);
  EXPECT_DOUBLE_EQ(solid.volume, 16 * kPi / 3);
  EXPECT_DOUBLE_EQ(solid.com.z, -1);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 1.2);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 1.2);
}

TEST(Shapes, CapsuleByHand) {
  // Radius 1, length 2: a tube of 2π and a ball of 4π/3, so 3/5 and 2/5 of the mass. Along z:
  // 3/5·1/2 + 2/5·2/5; across: 3/5·7/12 + 2/5 (2/5 + 1 + 3/4).
  const Solid solid = capsule(1, 2);
  EXPECT_DOUBLE_EQ(solid.volume, 10 * kPi / 3);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.izz, 0.46);
  EXPECT_DOUBLE_EQ(solid.unit_inertia.ixx, 0.35 + 0.86);
}

TEST(Shapes, Quadrature) {
  expect_close(box({0.4, 0.2, 1.2}),
               stacked({-0.6, 0.6}, [](double) { return test::rectangle(0.4, 0.2); }), kExactShape);
  expect_close(sphere(0.3), stacked({-0.3, 0.3}, [](double z) { return test::ball(0.3, z); }),
               kExactShape);
  expect_close(cylinder(0.2, 0.9), stacked({-0.45, 0.45}, [](double) { return test::circle(0.2); }),
               kExactShape);
  expect_close(capsule(0.2, 0.9),
               stacked({-0.65, -0.45, 0.45, 0.65},
                       [](double z) { return test::ball(0.2, std::max(0.0, std::abs(z) - 0.45)); }),
               kExactShape);
  expect_close(cone(0.4, 1.2),
               stacked({-0.6, 0.6}, [](double z) { return test::circle(0.4 * (0.6 - z) / 1.2); }),
               kExactShape);
  expect_close(ellipsoid({0.3, 0.7, 1.1}),
               stacked({-1.1, 1.1},
                       [](double z) {
                         const double share = std::sqrt(1 - z * z / (1.1 * 1.1));
                         return test::ellipse(0.3 * share, 0.7 * share);
                       }),
               kExactShape);
}

TEST(Shapes, LimitsAgree) {
  expect_close(capsule(0.3, 1e-12), sphere(0.3), 1e-11);
  expect_close(capsule(1e-12, 2), cylinder(1e-12, 2), 1e-11);
}

TEST(Shapes, DensityTimesVolumeIsMass) {
  const MassProperties body = of_density(box({0.1, 0.2, 0.3}), 7850);
  EXPECT_DOUBLE_EQ(body.mass, 47.1);
  EXPECT_DOUBLE_EQ(body.about_com.izz, 47.1 * 0.05 / 12);
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
