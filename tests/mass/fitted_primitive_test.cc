// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Primitives fitted to a block of 2 by 4 by 6 m, worked out by hand.

#include <rigor/mass/fitted_primitive.h>

#include <variant>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

using Fit = model::GeomWeight::Fit;

const Solid kBlock = box({2, 4, 6});

template <class Shape>
Shape fitted(Fit fit, double scale = 1) {
  return std::get<Shape>(fitted_primitive(kBlock, fit, scale).shape);
}

TEST(FittedPrimitive, HasTheSizeOfTheBoxOfTheMoments) {
  EXPECT_NEAR(fitted<model::Sphere>(Fit::kSphere).radius.value, 2, 1e-12);
  EXPECT_NEAR(fitted<model::Cylinder>(Fit::kCylinder).radius.value, 1.5, 1e-12);
  EXPECT_NEAR(fitted<model::Cylinder>(Fit::kCylinder).length.value, 6, 1e-12);
  EXPECT_NEAR(fitted<model::Capsule>(Fit::kCapsule).radius.value, 1.5, 1e-12);
  EXPECT_NEAR(fitted<model::Capsule>(Fit::kCapsule).length.value, 4.5, 1e-12);
  EXPECT_NEAR(
      length(fitted<model::Ellipsoid>(Fit::kEllipsoid).radii.value - model::Vector3{1, 2, 3}), 0,
      1e-12);
  EXPECT_NEAR(length(fitted<model::Box>(Fit::kBox, 0.5).size.value - model::Vector3{1, 2, 3}), 0,
              1e-12);
}

TEST(FittedPrimitive, LiesAsTheMeshDoes) {
  // The longest side along x, the next along z; the block is off the origin.
  Solid block = box({6, 2, 4});
  block.com = {1, 2, 3};
  const FittedPrimitive box = fitted_primitive(block, Fit::kBox, 1);
  EXPECT_EQ(box.X_MS.translation, block.com);
  const MassProperties as_box = transformed(box.X_MS, with_mass(*solid_of(box.shape), 12));
  const MassProperties as_mesh = with_mass(block, 12);
  EXPECT_NEAR(as_box.about_com.ixx, as_mesh.about_com.ixx, 1e-12);
  EXPECT_NEAR(as_box.about_com.iyy, as_mesh.about_com.iyy, 1e-12);
  EXPECT_NEAR(as_box.about_com.izz, as_mesh.about_com.izz, 1e-12);
  EXPECT_NEAR(as_box.about_com.ixy, 0, 1e-12);
}

}  // namespace
}  // namespace rigor::mass
