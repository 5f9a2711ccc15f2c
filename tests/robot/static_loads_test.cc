// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Holding efforts against closed forms, and against the slope of the potential energy, which is found
// from poses alone.

#include <cmath>
#include <numbers>

#include <rigor/robot/static_loads.h>

#include <robot/robots.h>

namespace rigor::test {
namespace {

using model::Vector3;
using robot::AxisLoad;
using robot::Positions;
using robot::Robot;

constexpr Vector3 kGravity{0, 0, -9.8};

double potential_energy(const Robot& robot, const Positions& positions, const Vector3& gravity) {
  const auto X_MB = body_poses(robot, followed(robot, positions));
  double energy = 0;
  for (std::size_t i = 0; i < X_MB.size(); ++i) {
    const auto& mass = robot.bodies[i].mass;
    energy -= mass.mass * dot(gravity, transform(X_MB[i], mass.com));
  }
  return energy;
}

std::size_t joint_named(const Robot& robot, const std::string& name) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (robot.joints[j].name == name) return j;
  }
  ADD_FAILURE() << name;
  return 0;
}

std::string link(const std::string& name, double mass, const std::string& com) {
  return "<link name='" + name + "'><inertial><origin xyz='" + com + "'/><mass value='" +
         std::to_string(mass) +
         "'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link>";
}

std::string joint(const std::string& name, const std::string& ends, const std::string& rest,
                  const std::string& type = "revolute") {
  return "<joint name='" + name + "' type='" + type + "'>" + ends + rest + "</joint>";
}

std::string pendulum(const std::string& limits) {
  return "<robot name='p'>" + link("a", 1, "0 0 0") + link("b", 2, "0.5 0 0") +
         joint("j", "<parent link='a'/><child link='b'/>",
               "<axis xyz='0 1 0'/><limit effort='8' velocity='1' " + limits + "/>") +
         "</robot>";
}

TEST(StaticLoads, OfAHorizontalPendulumAreItsWeightTimesItsArm) {
  const Robot robot = robot_from(pendulum("lower='-3' upper='3'"));
  // A turn about +y moves +x down: to hold it takes a negative effort.
  EXPECT_NEAR(holding_efforts(robot, {{0}}, kGravity)[0][0], -2 * 9.8 * 0.5, 1e-12);
  EXPECT_NEAR(holding_efforts(robot, {{std::numbers::pi / 2}}, kGravity)[0][0], 0, 1e-12);
  EXPECT_NEAR(holding_efforts(robot, {{std::numbers::pi / 3}}, kGravity)[0][0], -4.9, 1e-12);
}

TEST(StaticLoads, AreTheSlopeOfThePotentialEnergy) {
  const Robot robot = robot_from(kArmUrdf);
  const Vector3 gravity{1.5, -2.5, -9};
  const std::size_t shoulder = joint_named(robot, "shoulder"), elbow = joint_named(robot, "elbow"),
                    slide = joint_named(robot, "slide");
  for (int i = 0; i < 20; ++i) {
    Positions positions = followed(robot, {});
    positions[shoulder][0] = 0.7 * std::sin(3.0 * i);
    positions[elbow][0] = 2.5 * std::sin(5.0 * i + 1);
    const auto efforts = holding_efforts(robot, followed(robot, positions), gravity);
    constexpr double kStep = 1e-5;
    for (const std::size_t j : {shoulder, elbow}) {
      Positions above = positions, below = positions;
      above[j][0] += kStep;
      below[j][0] -= kStep;
      const double slope =
          (potential_energy(robot, above, gravity) - potential_energy(robot, below, gravity)) /
          (2 * kStep);
      EXPECT_NEAR(efforts[j][0], slope, 1e-6) << robot.joints[j].name;
    }
    EXPECT_EQ(efforts[slide][0], 0) << "the elbow bears it";
  }
}

TEST(StaticLoads, OfASliderAreTheWeightAlongIt) {
  const Robot robot =
      robot_from("<robot name='p'>" + link("a", 1, "0 0 0") + link("b", 3, "0.5 0 0") +
                 joint("j", "<parent link='a'/><child link='b'/>",
                       "<origin rpy='0.5 0 0'/><axis xyz='0 0 1'/><limit effort='9' velocity='1' "
                       "lower='0' upper='1'/>",
                       "prismatic") +
                 "</robot>");
  EXPECT_NEAR(holding_efforts(robot, {}, kGravity)[0][0], 3 * 9.8 * std::cos(0.5), 1e-12);
}

TEST(StaticLoads, AreRaisedToTheTrueMaximumWithinTheLimits) {
  // Horizontal is within the limits of the first: 9.8 N·m; of the second only cos 0.3 of it.
  const auto whole = static_loads(robot_from(pendulum("lower='-1' upper='2'")), {.samples = 3});
  ASSERT_EQ(whole.axes.size(), 1U);
  EXPECT_NEAR(std::abs(whole.axes[0].effort), 9.8, 1e-9);
  EXPECT_EQ(whole.axes[0].limit, 8);
  const auto part = static_loads(robot_from(pendulum("lower='0.3' upper='2'")), {.samples = 3});
  EXPECT_NEAR(std::abs(part.axes[0].effort), 9.8 * std::cos(0.3), 1e-9);
  EXPECT_NEAR(part.axes[0].at[0][0], 0.3, 1e-12);
}

TEST(StaticLoads, OfAStretchedArmAreFoundWhateverTheSamples) {
  // Two links of 1 m, 1 kg in their middles: stretched out, the shoulder holds 9.8 · (0.5 + 1.5) N·m.
  const Robot robot = robot_from(
      "<robot name='p'>" + link("a", 1, "0 0 0") + link("b", 1, "0 0 0.5") +
      link("c", 1, "0 0 0.5") +
      joint("s", "<parent link='a'/><child link='b'/>", "<axis xyz='1 0 0'/>", "continuous") +
      joint("e", "<parent link='b'/><child link='c'/>", "<origin xyz='0 0 1'/><axis xyz='1 0 0'/>",
            "continuous") +
      "</robot>");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto loads = static_loads(robot, {.samples = 5, .seed = seed});
    EXPECT_NEAR(std::abs(loads.axes[0].effort), 19.6, 1e-6);
    EXPECT_NEAR(std::abs(loads.axes[1].effort), 4.9, 1e-6);
  }
  const auto loads = static_loads(robot, {.samples = 2000});
  ASSERT_TRUE(loads.reach);
  EXPECT_NEAR(loads.reach->max.z, 1.5, 0.02) << "the farthest center of mass, straight up";
  EXPECT_NEAR(loads.reach->min.x, 0, 1e-12);
}

TEST(StaticLoads, AreTheSameForTheSameSeed) {
  const Robot robot = robot_from(kArmUrdf);
  const auto one = static_loads(robot, {.samples = 50, .seed = 7});
  const auto two = static_loads(robot, {.samples = 50, .seed = 7});
  ASSERT_EQ(one.axes.size(), two.axes.size());
  for (std::size_t i = 0; i < one.axes.size(); ++i) {
    EXPECT_EQ(one.axes[i].effort, two.axes[i].effort);
    EXPECT_EQ(one.axes[i].at, two.axes[i].at);
  }
}

}  // namespace
}  // namespace rigor::test
