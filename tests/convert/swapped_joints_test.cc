// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/swapped_joints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "convert/converted.h"
#include "robot/robots.h"

namespace rigor::convert {
namespace {

using Direction = robot::Edge::Direction;
using Directions = std::vector<robot::Edge::Direction>;
using test::Converted;
using test::sdf_joint;
using test::sdf_link;

TEST(SwappedJoints, LeavesATreeAsItIs) {
  EXPECT_EQ(robot::edge_directions({{1, 2}, {0, 1}, {0, 3}}, 4),
            (Directions(3, Direction::kAsWritten)));
}

TEST(SwappedJoints, TurnsTheLaterOfTwoThatLeadToOneBody) {
  EXPECT_EQ(robot::edge_directions({{0, 1}, {2, 1}}, 3),
            (Directions{Direction::kAsWritten, Direction::kTurned}));
}

TEST(SwappedJoints, TurnsAWholeWayWhereItMust) {
  // 3 → 2 → 1 ← 0, and nothing turns the joint from 0: so 2 → 1 and 3 → 2 turn.
  EXPECT_EQ(robot::edge_directions({{2, 1}, {3, 2}, {0, 1, false}}, 4),
            (Directions{Direction::kTurned, Direction::kTurned, Direction::kAsWritten}));
}

TEST(SwappedJoints, TheWorldHangsOnNothing) {
  // Body 2 is the world: what hung on 0 before directions on it now.
  EXPECT_EQ(robot::edge_directions({{0, 1}, {2, 1}}, 3, 2),
            (Directions{Direction::kTurned, Direction::kAsWritten}));
}

TEST(SwappedJoints, LeavesOutWhatClosesALoop) {
  EXPECT_EQ(robot::edge_directions({{0, 1}, {0, 2}, {1, 2}}, 3),
            (Directions{Direction::kAsWritten, Direction::kAsWritten, Direction::kLeftOut}));
  EXPECT_EQ(robot::edge_directions({{0, 1}, {1, 0}}, 2),
            (Directions{Direction::kAsWritten, Direction::kLeftOut}));
}

TEST(SwappedJoints, AnyTreeHangsOnOneRoot) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    constexpr std::uint32_t kBodies = 12;
    std::vector<robot::Edge> edges;
    for (std::uint32_t i = 1; i < kBodies; ++i) {
      const std::uint32_t other = static_cast<std::uint32_t>(random() % i);
      edges.push_back(random() % 2 == 0 ? robot::Edge{other, i} : robot::Edge{i, other});
    }
    const Directions directions = robot::edge_directions(edges, kBodies);
    std::vector<int> parents(kBodies);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ASSERT_NE(directions[i], Direction::kLeftOut);
      ++parents[directions[i] == Direction::kTurned ? edges[i].parent : edges[i].child];
    }
    // All bodies but one have one parent, and without a loop that is a tree.
    EXPECT_EQ(std::count(parents.begin(), parents.end(), 1), kBodies - 1);
    EXPECT_EQ(std::count(parents.begin(), parents.end(), 0), 1);
  }
}

TEST(SwappedJoints, TheRobotMovesAsBefore) {
  // The lid's hinge leads to the box, which the base carries already; it stands in the box's frame, and
  // the lid a meter along x from it.
  const Converted converted(sdf_link("base") + sdf_link("box", "0 0 1 0 0 0") +
                            sdf_link("lid", "1 0 1 0 0 0") +
                            sdf_joint("weld", "fixed", "base", "box") +
                            sdf_joint("hinge", "revolute", "lid", "box",
                                      "<axis><xyz>0 0 1</xyz><limit><lower>-0.5</lower><upper>2"
                                      "</upper></limit></axis>"));
  const auto notes = converted.notes(NoteKind::kTurned);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].subject, "m/joint hinge");
  const UrdfJoint& hinge = converted.joint("hinge");
  EXPECT_EQ(hinge.parent, "box");
  EXPECT_EQ(hinge.child, "lid");
  EXPECT_EQ(test::digits_of(*hinge.axis), "0 0 -1");
  EXPECT_EQ(hinge.limit->lower->value, -0.5);
  EXPECT_EQ(hinge.limit->upper->value, 2);

  // A quarter turn of the box in the lid about z is one of the lid in the box the other way: the lid's
  // own origin, (1, 0, 0) in the box at rest, comes to (0, -1, 0).
  const robot::Robot robot = test::robot_from(urdf_text(*converted.result.robot));
  robot::Positions positions;
  std::size_t lid = 0;
  for (const robot::Joint& joint : robot.joints) {
    positions.push_back(std::vector<double>(joint.axes.size(), std::numbers::pi / 2));
    if (joint.name == "hinge") lid = joint.child;
  }
  const auto poses = body_poses(robot, positions);
  const model::Vector3 center = robot.bodies[lid].mass.com;  // the lid's origin, where its mass is
  const model::Vector3 at = compose(poses[lid], model::Pose{center, {}}).translation;
  EXPECT_NEAR(at.x, 0, 1e-12);
  EXPECT_NEAR(at.y, -1, 1e-12);
  EXPECT_NEAR(at.z, 1, 1e-12);
}

TEST(SwappedJoints, TwoAxesInARowAreNotTurned) {
  const Converted converted(
      sdf_link("base") + sdf_link("box") + sdf_link("lid") +
          sdf_joint("weld", "fixed", "base", "box") +
          sdf_joint("cross", "universal", "lid", "box",
                    "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>"),
      "1.9");
  // The way from the box up to the base turns instead.
  ASSERT_TRUE(converted.result.robot);
  EXPECT_EQ(converted.joint("weld").parent, "box");
  EXPECT_EQ(converted.joint("weld").child, "base");
  EXPECT_EQ(converted.notes(NoteKind::kTurned).size(), 1U);
}

}  // namespace
}  // namespace rigor::convert
