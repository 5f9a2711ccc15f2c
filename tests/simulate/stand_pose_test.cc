// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the joints of a legged robot are moved to so that it stands, held against the geometry of legs made by hand.

#include <rigor/simulate/pose/stand_pose.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <rigor/simulate/footprint.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/pose/posing.h>
#include <rigor/simulate/reach.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

#include "simulate/hand_robot.h"
#include "simulate/hand_scene.h"

namespace rigor {
namespace {

using namespace simulate;

constexpr double kThigh = 0.3;  // m
constexpr double kQuarterTurn = std::numbers::pi / 2;

/// Limits of a leg's two hinges about y, rad.
struct LegLimits {
  double hip_lower, hip_upper, knee_lower, knee_upper;
};

/// A thigh and a shin, each 0.3 m, that begin stretched out level along x, a ball at the end. Bodies are added in that order.
void add_leg(Scene& scene, const Vector3& hip, const LegLimits& limits, double foot) {
  const Vector3 knee = hip + Vector3{kThigh, 0, 0};
  const std::uint32_t thigh = hand::add_body(scene, hand::ball_mass(1, 0.05), hip);
  const std::uint32_t shin = hand::add_body(scene, hand::ball_mass(0.5, 0.05), knee);
  hand::add_shape(scene, shin, mesh::Sphere{foot}, {{kThigh, 0, 0}, {}});
  const auto add = [&](std::uint32_t parent, std::uint32_t child, const Vector3& anchor,
                       double lower, double upper) {
    hand::add_joint(scene, model::JointType::kRevolute, parent, child, anchor, {{0, 1, 0}});
    scene.joints.back().axes[0].lower = lower;
    scene.joints.back().axes[0].upper = upper;
  };
  add(0, thigh, hip, limits.hip_lower, limits.hip_upper);
  add(thigh, shin, knee, limits.knee_lower, limits.knee_upper);
}

/// A trunk of 0.6 m on four legs: at zero it balances on its round belly.
Scene quadruped(const LegLimits& limits) {
  Scene scene = hand::scene();
  hand::add_body(scene, hand::box_mass(10, {0.6, 0.3, 0.1}), {0, 0, 0.05});
  hand::add_shape(scene, 0, mesh::Sphere{0.05});
  for (const double x : {0.25, -0.25}) {
    for (const double y : {0.15, -0.15}) add_leg(scene, {x, y, 0.05}, limits, 0.02);
  }
  scene.size = 1.3;
  return scene;
}

double foot_height(const Scene& scene, std::uint32_t shin) {
  return transform(scene.bodies[shin].X_WB, {kThigh, 0, 0}).z;
}

/// A hip turned by a, a knee by b: the foot is 0.3 (sin a + sin(a + b)) below the hip.
TEST(StandPose, PosingIsForwardKinematics) {
  const Scene scene = quadruped({-3, 3, -3, 3});
  Posing posing(scene);
  ASSERT_TRUE(posing.is_tree());
  std::vector<double> positions = posing.start();
  positions[0] = 0.7;
  positions[1] = 0.4;
  const Scene& posed = posing.at(positions);
  const Vector3 foot = transform(posed.bodies[2].X_WB, {kThigh, 0, 0});
  EXPECT_NEAR(foot.z, 0.05 - kThigh * (std::sin(0.7) + std::sin(1.1)), 1e-12);
  EXPECT_NEAR(foot.x, 0.25 + kThigh * (std::cos(0.7) + std::cos(1.1)), 1e-12);
  EXPECT_NEAR(posed.joints[1].anchor_W.z, 0.05 - kThigh * std::sin(0.7), 1e-12);
  EXPECT_EQ(posed.joints[1].axes[0].start, 0.4);
  EXPECT_EQ(foot_height(posed, 4), 0.05);  // the other legs are where they were
  EXPECT_EQ(foot_height(posing.at(posing.start()), 2), 0.05);
}

TEST(StandPose, FourLegsInTheMiddleOfTheirLimits) {
  // Middle: hips at 90°, knees straight.
  const Scene scene = quadruped({0, 2 * kQuarterTurn, -1, 1});
  const StandPose pose = find_stand_pose(scene, {}, {});
  ASSERT_TRUE(pose.found());
  EXPECT_EQ(pose.from, "the middle of the limits of its legs");
  for (std::size_t leg = 0; leg < 4; ++leg) {
    EXPECT_NEAR(pose.positions[2 * leg], kQuarterTurn, 1e-12);
    EXPECT_NEAR(pose.positions[2 * leg + 1], 0, 1e-12);
  }
  const Scene standing = in_stand_pose(scene, pose);
  EXPECT_NEAR(lowest_of_model(standing, 0), 0, 1e-9);
  EXPECT_NEAR(standing.bodies[0].X_WB.translation.z, 2 * kThigh + 0.02, 1e-9);
  EXPECT_TRUE(stands_by_itself(standing, 0));
  EXPECT_NE(in_words(scene, pose).find("joint0=1.57 rad"), std::string::npos);
}

TEST(StandPose, ASearchPutsFourFeetOnTheGround) {
  // In the middle the legs still point up.
  const Scene scene = quadruped({-2.4, 1.4, -1.5, 1.5});
  const StandPose pose = find_stand_pose(scene, {}, {});
  ASSERT_TRUE(pose.found());
  EXPECT_NE(pose.from, "the middle of the limits of its legs");
  for (std::size_t j = 0; j < 8; ++j) {
    const SceneAxis& axis = scene.joints[j].axes[0];
    EXPECT_GE(pose.positions[j], axis.lower);
    EXPECT_LE(pose.positions[j], axis.upper);
  }
  // Both of a pair alike: the first leg is the left front one, the second the right front one.
  EXPECT_EQ(pose.positions[0], pose.positions[2]);
  EXPECT_EQ(pose.positions[1], pose.positions[3]);
  const Scene standing = in_stand_pose(scene, pose);
  for (const std::uint32_t shin : {2U, 4U, 6U, 8U}) {
    EXPECT_NEAR(foot_height(standing, shin), 0.02, 0.01 * scene.size);
  }
  EXPECT_GT(standing.bodies[0].X_WB.translation.z, 0.1);  // the belly is off the ground
  const auto corners = footprint_at_start(standing, 0, kFeetSlack * scene.size);
  ASSERT_GE(corners.size(), 3U);
  EXPECT_GT(margin_in(corners, center_of_mass(standing, 0)).distance, 0);
}

TEST(StandPose, APoseThatSomebodyNamedGoesFirst) {
  const Scene scene = quadruped({0, 2 * kQuarterTurn, -1, 1});
  GroupState named{"standing", "dog.srdf", {}};
  for (const char* hip : {"joint0", "joint2", "joint4", "joint6"}) {
    named.positions.emplace_back(hip, 1.4);
  }
  const StandPose pose = find_stand_pose(scene, {}, {named});
  ASSERT_TRUE(pose.found());
  EXPECT_EQ(pose.from, "the state 'standing' of dog.srdf");
  EXPECT_EQ(pose.positions[0], 1.4);
  // One that does not stand is no help: one leg in the air, the others bent.
  named.positions = {{"joint0", 0.0}};
  EXPECT_EQ(find_stand_pose(scene, {}, {named}).from, "the middle of the limits of its legs");
}

TEST(StandPose, TwoPointsAreNoStanceAndWheelsNeedNone) {
  Scene biped = hand::scene();
  hand::add_body(biped, hand::box_mass(10, {0.2, 0.2, 0.4}), {0, 0, 0.2});
  hand::add_shape(biped, 0, mesh::Sphere{0.2});
  for (const double y : {0.1, -0.1}) add_leg(biped, {0, y, 0.2}, {-3, 3, -3, 3}, 0.001);
  biped.size = 0.9;
  const StandPose none = find_stand_pose(biped, {}, {});
  EXPECT_EQ(none.need, StandPose::Need::kNotFound);
  EXPECT_FALSE(in_words(biped, none).empty());
  const Scene robot = hand::tutorial_robot();
  EXPECT_EQ(find_stand_pose(robot, find_wheels(robot, {}), {}).need, StandPose::Need::kNone);
}

TEST(StandPose, StatesAreReadFromTheSrdfBesideTheRobot) {
  MemoryDisk disk;
  disk.put("dog/urdf/dog.urdf", "<robot name='dog'/>");
  disk.put(
      "dog/srdf/dog.srdf",
      "<robot name='dog'><group_state name='home' group='legs'><joint name='hip' value='0.5'/>"
      "</group_state><group_state name='folded' group='legs'/><group_state name='standing' "
      "group='front'><joint name='hip' value='0.9'/><joint name='root' value='0 0 "
      "1'/></group_state>"
      "<group_state name='standing' group='back'><joint name='knee' value='-1e-1'/></group_state>"
      "</robot>");
  disk.put("dog/srdf/cat.srdf",
           "<robot name='cat'><group_state name='standing' group='legs'/></robot>");
  Sources sources;
  read::Workspace workspace(disk, sources);
  const auto states = group_states("dog/urdf/dog.urdf", "dog", workspace);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].name, "standing");
  EXPECT_EQ(states[0].file, "dog.srdf");
  ASSERT_EQ(states[0].positions.size(), 2U);
  EXPECT_EQ(states[0].positions[0].second, 0.9);
  EXPECT_EQ(states[0].positions[1].first, "knee");
  EXPECT_EQ(states[1].name, "home");
}

}  // namespace
}  // namespace rigor
