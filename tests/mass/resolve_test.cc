// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/resolve.h>

#include <cmath>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

constexpr Inertia kIdentity{1, 0, 0, 1, 0, 1};

/// One model with one link, as the readers leave it.
model::Root root_with(model::Format format, const model::Inertial& inertial) {
  model::Root root;
  root.format = format;
  model::Model model;
  model.format = format;
  model::Link link;
  link.model = {0};
  link.inertial = inertial;
  root.models.push_back(model);
  root.links.push_back(link);
  return root;
}

MassProperties resolved(model::Format format, const model::Inertial& inertial) {
  return resolve(root_with(format, inertial), {0});
}

model::Field<double> written(double value) { return {value, {}, true}; }

model::Inertial complete() {
  model::Inertial inertial;
  inertial.written = inertial.tensor_written = true;
  inertial.mass = written(2);
  inertial.ixx = written(1);
  inertial.ixy = written(0.1);
  inertial.ixz = written(0.2);
  inertial.iyy = written(2);
  inertial.iyz = written(0.3);
  inertial.izz = written(2.5);
  return inertial;
}

TEST(Resolve, WhatIsMissingInSdfIsOneKilogram) {
  EXPECT_EQ(resolved(model::Format::kSdf, {}), (MassProperties{1, {}, kIdentity}));
}

TEST(Resolve, AMassAloneKeepsTheIdentityInSdf) {
  model::Inertial inertial;
  inertial.written = true;
  inertial.mass = written(0.05);
  EXPECT_EQ(resolved(model::Format::kSdf, inertial), (MassProperties{0.05, {}, kIdentity}));
}

TEST(Resolve, WhatIsMissingInUrdfIsNothing) {
  EXPECT_EQ(resolved(model::Format::kUrdf, {}), MassProperties{});
  model::Inertial inertial = complete();
  inertial.iyz.written = false;
  EXPECT_EQ(resolved(model::Format::kUrdf, inertial), MassProperties{});
}

TEST(Resolve, WhatIsWrittenIsTaken) {
  model::Inertial inertial = complete();
  inertial.pose.pose.value.translation = {1, 2, 3};
  const MassProperties expected{2, {1, 2, 3}, {1, 0.1, 0.2, 2, 0.3, 2.5}};
  EXPECT_EQ(resolved(model::Format::kSdf, inertial), expected);
  EXPECT_EQ(resolved(model::Format::kUrdf, inertial), expected);
}

TEST(Resolve, ThePoseTurnsTheTensor) {
  model::Inertial inertial = complete();
  inertial.pose.pose.value.rotation = model::from_rpy(0, 0, std::acos(0.0));
  const Inertia turned = resolved(model::Format::kSdf, inertial).about_com;
  EXPECT_NEAR(turned.ixx, 2, 1e-15);
  EXPECT_NEAR(turned.iyy, 1, 1e-15);
  EXPECT_NEAR(turned.ixy, -0.1, 1e-15);
  EXPECT_NEAR(turned.ixz, -0.3, 1e-15);
  EXPECT_NEAR(turned.iyz, 0.2, 1e-15);
}

TEST(Resolve, AutomaticIsSaid) {
  model::Link link;
  EXPECT_FALSE(is_automatic(link));
  link.inertial.automatic.value = true;
  EXPECT_TRUE(is_automatic(link));
}

}  // namespace
}  // namespace rigor::mass
