// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/unpowered.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using namespace simulate;

using JointIndices = std::vector<std::uint32_t>;

/// Two links in a row on the world, upright, whose joints have an effort of 0.
Scene exported_arm() {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::ball_mass(2, 0.05), {0, 0, 1.3});
  hand::add_body(scene, hand::ball_mass(1, 0.05), {0, 0, 1.8});
  hand::add_joint(scene, model::JointType::kRevolute, kWorld, 0, {0, 0, 1}, {{0, 0, 1}});
  hand::add_joint(scene, model::JointType::kRevolute, 0, 1, {0, 0, 1.5}, {{0, 1, 0}});
  for (SceneJoint& joint : scene.joints) {
    joint.axes[0].lower = -2;
    joint.axes[0].upper = 2;
    joint.axes[0].effort = joint.axes[0].velocity = 0;
  }
  return scene;
}

/// Upright is no place to stay: it falls to either side.
TEST(Unpowered, AnArmWithoutEffortDrops) {
  const Scene scene = exported_arm();
  EXPECT_EQ(unpowered_joints(scene, {}), (JointIndices{0, 1}));
  const Fact fact = about_unpowered(scene, {0, 1});
  EXPECT_EQ(fact.kind, FactKind::kNoMotor);
  EXPECT_EQ(fact.name, "joint0, joint1");
  EXPECT_FALSE(fact.severe);
  const Scene held = powered(scene, {0, 1});
  EXPECT_EQ(held.joints[1].axes[0].effort, kInfinity);
  EXPECT_EQ(held.joints[1].axes[0].velocity, kInfinity);
}

TEST(Unpowered, WhatStaysWhereItIsNeedsNoMotor) {
  Scene pendulum = exported_arm();
  pendulum.bodies[1].X_WB.translation.z = 1.2;  // below its hinge
  EXPECT_TRUE(unpowered_joints(pendulum, {}).empty());
  Scene stiff = exported_arm();
  stiff.bodies[1].X_WB.translation = {0.3, 0, 1.5};  // 2.94 N·m
  EXPECT_FALSE(unpowered_joints(stiff, {}).empty());
  stiff.joints[1].axes[0].friction = 3.2;
  EXPECT_TRUE(unpowered_joints(stiff, {}).empty());
  Scene lying = exported_arm();
  lying.bodies[1].X_WB.translation = {0.3, 0, 1.5};
  lying.joints[1].axes[0].upper = 0;  // on its stop
  EXPECT_TRUE(unpowered_joints(lying, {}).empty());
}

TEST(Unpowered, OneMotorAmongThemMakesTheOthersPassive) {
  Scene scene = exported_arm();
  scene.joints[0].axes[0].effort = 5;
  EXPECT_TRUE(unpowered_joints(scene, {}).empty());
  scene = exported_arm();
  scene.alone = false;
  EXPECT_TRUE(unpowered_joints(scene, {}).empty());
  Scene robot = hand::tutorial_robot();
  for (SceneJoint& joint : robot.joints) joint.axes[0].effort = 0;
  EXPECT_TRUE(unpowered_joints(robot, find_wheels(robot, {})).empty());
}

}  // namespace
}  // namespace rigor
