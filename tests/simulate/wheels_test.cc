// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/wheels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/reach.h>

#include "simulate/hand_robot.h"

namespace rigor {
namespace {

using namespace simulate;
using hand::hinge;
using hand::shape_of;
using hand::tutorial_robot;

TEST(Wheels, OfTheTutorialRobot) {
  const DriveTrain train = find_wheels(tutorial_robot(), {});
  ASSERT_EQ(train.left.size(), 1U);
  ASSERT_EQ(train.right.size(), 1U);
  EXPECT_EQ(train.left[0].joint, 0U);
  EXPECT_EQ(train.left[0].shape, 2U);
  EXPECT_EQ(train.right[0].joint, 1U);
  EXPECT_NEAR(train.forward_W.x, 1, 1e-12);
  EXPECT_NEAR(train.left[0].radius, 0.1, 1e-12);
  EXPECT_NEAR(train.left[0].width, 0.05, 1e-12);
  EXPECT_NEAR(train.track, 0.26, 1e-12);
  EXPECT_NEAR(train.left[0].center_W.y, 0.13, 1e-12);
  // Turning about +y carries the top of a wheel towards +x.
  EXPECT_EQ(train.left[0].sign, 1);
  EXPECT_EQ(train.casters, std::vector<std::uint32_t>{1});
  EXPECT_TRUE(train.steers());
}

TEST(Wheels, AReversedAxisHasTheOtherSign) {
  Scene scene = tutorial_robot();
  scene.joints[1].axes[0].direction_W = {0, -1, 0};
  const DriveTrain train = find_wheels(scene, {});
  EXPECT_EQ(train.left.at(0).sign, 1);
  EXPECT_EQ(train.right.at(0).sign, -1);
}

/// A model that is drawn along its y faces the way that a positive velocity rolls it: nothing else is said of it.
TEST(Wheels, OfAModelDrawnAlongYThePositiveVelocityIsAhead) {
  Scene scene = tutorial_robot();
  const Pose turn{{}, model::from_rpy(0, 0, -std::numbers::pi / 2)};
  for (SceneBody& body : scene.bodies)
    body.X_WB.translation = transform(turn, body.X_WB.translation);
  for (std::size_t b = 1; b < scene.bodies.size(); ++b) {
    scene.bodies[b].X_WB.rotation = turn.rotation * scene.bodies[b].X_WB.rotation;
  }
  for (SceneJoint& joint : scene.joints) {
    joint.anchor_W = transform(turn, joint.anchor_W);
    joint.axes[0].direction_W = rotate(turn.rotation, joint.axes[0].direction_W);
  }
  const DriveTrain train = find_wheels(scene, {});  // forward was y, and every wheel reversed
  EXPECT_NEAR(train.forward_W.y, -1, 1e-12);
  ASSERT_FALSE(train.left.empty() || train.right.empty());
  EXPECT_EQ(train.left[0].sign, 1);
  EXPECT_EQ(train.right[0].sign, 1);
}

TEST(Wheels, ForwardIsTheModelsXEvenWhenItIsTurned) {
  Scene scene = tutorial_robot();
  const Pose turn{{}, model::from_rpy(0, 0, 2.5)};
  for (SceneBody& body : scene.bodies) body.X_WB = compose(turn, body.X_WB);
  for (SceneJoint& joint : scene.joints) {
    joint.anchor_W = transform(turn, joint.anchor_W);
    joint.axes[0].direction_W = rotate(turn.rotation, joint.axes[0].direction_W);
  }
  const DriveTrain train = find_wheels(scene, {});
  EXPECT_NEAR(train.forward_W.x, std::cos(2.5), 1e-12);
  EXPECT_NEAR(train.forward_W.y, std::sin(2.5), 1e-12);
  EXPECT_EQ(train.left.at(0).joint, 0U);
  EXPECT_EQ(train.left.at(0).sign, 1);
}

TEST(Wheels, AreNoneWhereTheJointHasLimitsOrIsUpright) {
  Scene scene = tutorial_robot();
  scene.joints[0].axes[0].lower = -1;
  scene.joints[0].axes[0].upper = 1;
  scene.joints[1].axes[0].direction_W = {0, 0, 1};
  EXPECT_TRUE(find_wheels(scene, {}).empty());
  // The knees of a real quadruped travel 18.8 rad; the pendulums of a real world, without an end, 200.
  scene.joints[0].axes[0].lower = -9.4;
  scene.joints[0].axes[0].upper = 9.4;
  EXPECT_TRUE(find_wheels(scene, {}).empty());
  scene.joints[0].axes[0].lower = -100;
  scene.joints[0].axes[0].upper = 100;
  EXPECT_EQ(find_wheels(scene, {}).left.size(), 1U);
}

TEST(Wheels, ANameIsThatOfAThingOrItsEnd) {
  EXPECT_TRUE(is_named("robot::arm::elbow", "robot::arm::elbow"));
  EXPECT_TRUE(is_named("robot::arm::elbow", "arm::elbow"));
  EXPECT_TRUE(is_named("robot::arm::elbow", "elbow"));
  EXPECT_FALSE(is_named("robot::arm::elbow", "bow"));
  EXPECT_FALSE(is_named("robot::arm::elbow", "arm"));
  EXPECT_FALSE(is_named("elbow", "arm::elbow"));
}

TEST(Wheels, NamedOnesNeedNoOpenLimitsAndTakeTheEndOfAName) {
  Scene scene = tutorial_robot();
  for (SceneJoint& joint : scene.joints) {
    joint.axes[0].lower = -1;
    joint.axes[0].upper = 1;
  }
  const DriveTrain train = find_wheels(scene, {"my_robot::left_wheel_hinge", "right_wheel_hinge"});
  EXPECT_EQ(train.left.size(), 1U);
  EXPECT_EQ(train.right.size(), 1U);
  EXPECT_TRUE(find_wheels(scene, {"wheel_hinge"}).empty());
}

TEST(Wheels, ASwivellingCasterWheelDoesNotDrive) {
  Scene scene = tutorial_robot();
  SceneBody fork;
  fork.X_WB.translation = {-0.15, 0, 0.1};
  scene.bodies.push_back(fork);  // 3
  SceneBody roller;
  roller.X_WB = {{-0.17, 0, 0.05}, model::from_rpy(std::numbers::pi / 2, 0, 0)};
  scene.bodies.push_back(roller);  // 4
  scene.shapes[1] = shape_of(4, mesh::Cylinder{0.05, 0.02});
  scene.joints.push_back(hinge("swivel", 0, 3, {-0.15, 0, 0.1}, {0, 0, 1}));
  scene.joints.push_back(hinge("roller", 3, 4, {-0.17, 0, 0.05}, {0, 1, 0}));
  const DriveTrain train = find_wheels(scene, {});
  EXPECT_EQ(train.left.size(), 1U);
  EXPECT_EQ(train.right.size(), 1U);
  EXPECT_EQ(train.casters, std::vector<std::uint32_t>{1});
}

/// A wheel is what looks like one: its hinge's axis may be 20° off, level or not.
TEST(Wheels, AHingeThatIsOffMakesAWheelNoOtherThing) {
  for (const Vector3& axis :
       {Vector3{0, std::cos(0.35), std::sin(0.35)}, Vector3{std::sin(0.35), std::cos(0.35), 0}}) {
    Scene scene = tutorial_robot();
    scene.joints[0].axes[0].direction_W = axis;
    const DriveTrain train = find_wheels(scene, {});
    EXPECT_EQ(train.left.size(), 1U);
    EXPECT_EQ(train.right.size(), 1U);
    EXPECT_NEAR(train.forward_W.x, 1, 1e-9);
  }
}

TEST(Wheels, AWheelOffItsAxisIsFoundWithBothPlaces) {
  Scene scene = tutorial_robot();
  scene.shapes[2].X_BS.translation = {0.01, 0, 0};  // the wheel's x points down
  const DriveTrain train = find_wheels(scene, {});
  ASSERT_EQ(train.left.size(), 1U);
  EXPECT_NEAR(length(train.left[0].middle_W - train.left[0].center_W), 0.01, 1e-12);
}

mesh::TriangleMesh prism(int corners, double radius, double width) {
  mesh::TriangleMesh made;
  for (const double end : {-0.5, 0.5}) {
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      made.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), end * width});
    }
  }
  return made;
}

TEST(Wheels, AMeshIsRoundWhenItHasCornersEnough) {
  Scene scene = tutorial_robot();
  scene.meshes = {prism(24, 0.1, 0.05), prism(4, 0.1, 0.05)};
  scene.shapes[2].kind = TriangleSoup{0};
  scene.shapes[3].kind = TriangleSoup{1};
  const DriveTrain train = find_wheels(scene, {});
  ASSERT_EQ(train.left.size() + train.right.size(), 1U);
  const Wheel& wheel = train.left.at(0);
  EXPECT_EQ(wheel.joint, 0U);
  // What a prism of 24 sides rolls in a turn is its outline.
  EXPECT_NEAR(wheel.radius, 24 * 0.1 * std::sin(std::numbers::pi / 24) / std::numbers::pi, 1e-4);
  EXPECT_NEAR(wheel.width, 0.05, 1e-9);
  EXPECT_FALSE(train.steers());
}

TEST(Wheels, FourOfThemHaveTwoOnEachSide) {
  Scene scene = tutorial_robot();
  for (std::uint32_t i = 0; i < 2; ++i) {
    SceneBody rear = scene.bodies[1 + i];
    rear.X_WB.translation.x = -0.1;
    scene.bodies.push_back(rear);
    scene.shapes.push_back(shape_of(3 + i, mesh::Cylinder{0.1, 0.05}));
    scene.joints.push_back(hinge("rear", 0, 3 + i, rear.X_WB.translation, {0, 1, 0}));
  }
  const DriveTrain train = find_wheels(scene, {});
  EXPECT_EQ(train.left.size(), 2U);
  EXPECT_EQ(train.right.size(), 2U);
  EXPECT_NEAR(train.track, 0.26, 1e-12);
}

TEST(Reach, OfEachShape) {
  const double slant = 1 / std::sqrt(2.0);
  const Vector3 diagonal{slant, 0, slant};
  Scene scene;
  scene.bodies.emplace_back();
  scene.meshes = {{.positions = {{3, 0, 0}, {0, 0, -1}}}};
  const auto of = [&](SceneShapeKind kind) {
    return reach(scene, shape_of(0, std::move(kind), {{0, 0, 5}, {}}), diagonal) - 5 * slant;
  };
  EXPECT_NEAR(of(mesh::Box{{2, 4, 6}}), slant * (1 + 3), 1e-12);
  EXPECT_NEAR(of(mesh::Sphere{2}), 2, 1e-12);
  EXPECT_NEAR(of(mesh::Cylinder{1, 4}), slant * (1 + 2), 1e-12);
  EXPECT_NEAR(of(mesh::Capsule{1, 4}), slant * 2 + 1, 1e-12);
  EXPECT_NEAR(of(TriangleSoup{0}), slant * 3, 1e-12);
  EXPECT_EQ(of(HalfSpace{}), kInfinity);
}

TEST(Footprint, OfTheTutorialRobotIsATriangle) {
  const Scene scene = tutorial_robot();
  const std::vector<Vector3> corners = footprint_at_start(scene, 0, 0.001);
  ASSERT_GE(corners.size(), 3U);  // the caster, and the outer ends of the wheels' lines
  // The center of mass: 1 kg of wheels at x = 0.1, 5 kg at 0.
  const Vector3 com = center_of_mass(scene, 0);
  EXPECT_NEAR(com.x, 0.1 / 6, 1e-12);
  // The side between the wheels, at x = 0.1, is nearer than those from the caster (-0.15, 0) to (0.1, ±0.155).
  EXPECT_NEAR(margin_in(corners, com).distance, 0.1 - com.x, 1e-9);
  EXPECT_NEAR(margin_in(corners, com).half_width, 0.125, 1e-9);
  EXPECT_LT(margin_in(corners, {-0.1, 0.1, 0}).distance, 0);
}

TEST(Footprint, OfASquareWithAPointWithin) {
  const std::vector<Vector3> corners =
      footprint({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}});
  EXPECT_EQ(corners.size(), 4U);
  const FootprintMargin margin = margin_in(corners, {1.5, 1, 0});
  EXPECT_NEAR(margin.distance, 0.5, 1e-12);
  EXPECT_NEAR(margin.half_width, 1, 1e-12);
  EXPECT_NEAR(margin.outward.x, 1, 1e-12);
}

TEST(Footprint, OfALineHasNoArea) {
  EXPECT_LT(footprint({{0, 0, 0}, {1, 0, 0}, {2, 1e-6, 0}, {3, 0, 0}}).size(), 3U);
}

std::vector<std::string> idle_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const IdleWheel& wheel : idle_wheels(scene, find_wheels(scene, {}))) {
    names.push_back(scene.joints[wheel.joint].name);
  }
  return names;
}

const std::vector<std::string> kBothWheels{"my_robot::left_wheel_hinge",
                                           "my_robot::right_wheel_hinge"};

/// 40 mm is nearly half a radius: such are not found as wheels, and the robot slides on its belly.
TEST(Wheels, ThoseAboveTheGroundAreIdle) {
  EXPECT_TRUE(idle_names(hand::tutorial_robot()).empty());
  for (const double above : {0.01, 0.04}) {
    Scene scene = hand::tutorial_robot();
    for (const std::uint32_t body : {1U, 2U}) scene.bodies[body].X_WB.translation.z += above;
    for (SceneJoint& joint : scene.joints) joint.anchor_W.z += above;
    EXPECT_EQ(idle_names(scene), kBothWheels) << above;
    const std::vector<IdleWheel> idle = idle_wheels(scene, find_wheels(scene, {}));
    EXPECT_NEAR(idle[0].above, above, 1e-9);
    EXPECT_EQ(idle[0].travel, kInfinity);
  }
}

/// A hinge of ±π stops what should roll on.
TEST(Wheels, ThoseOfAJointWithLimitsAreIdle) {
  Scene scene = hand::tutorial_robot();
  for (SceneJoint& joint : scene.joints) {
    joint.axes[0].lower = -3.14;
    joint.axes[0].upper = 3.14;
  }
  EXPECT_EQ(idle_names(scene), kBothWheels);
  const std::vector<IdleWheel> idle = idle_wheels(scene, find_wheels(scene, {}));
  EXPECT_EQ(idle[0].above, 0);
  EXPECT_NEAR(idle[0].travel, 6.28, 1e-9);
  // What turns by less is a flap or a finger.
  for (SceneJoint& joint : scene.joints) joint.axes[0].lower = 2;
  EXPECT_TRUE(idle_names(scene).empty());
}

}  // namespace
}  // namespace rigor
