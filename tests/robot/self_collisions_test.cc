// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Pairs of links whose distance has a closed form: bars and balls on joints, where it is known at which
// angles they touch.

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <rigor/robot/collision/self_collisions.h>

#include <robot/robots.h>

namespace rigor::test {
namespace {

using robot::PairKind;

std::string ball_link(const std::string& name, double radius, const std::string& at = "0 0 0") {
  return "<link name='" + name + "'><collision><origin xyz='" + at +
         "'/><geometry><sphere radius='" + std::to_string(radius) +
         "'/></geometry></collision></link>";
}

std::string bare_link(const std::string& name) { return "<link name='" + name + "'/>"; }

std::string hinge(const std::string& parent, const std::string& child, const std::string& at,
                  const std::string& limits, const std::string& type = "revolute") {
  return "<joint name='" + parent + '_' + child + "' type='" + type + "'><origin xyz='" + at +
         "'/><parent link='" + parent + "'/><child link='" + child +
         "'/><axis xyz='0 0 1'/><limit effort='1' velocity='1' " + limits + "/></joint>";
}

std::string robot_text(const std::string& inside) {
  return "<robot name='r'>" + inside + "</robot>";
}

robot::FoundSurface no_surface(const robot::Shape&) { return {nullptr, "none"}; }

std::map<std::string, PairKind> kinds_of(const robot::Robot& robot,
                                         const robot::SampleOptions& options = {.samples = 2000},
                                         unsigned threads = 1) {
  const robot::CollisionBodies bodies(robot, no_surface);
  Turns turns(threads);
  std::map<std::string, PairKind> kinds;
  for (const auto& pair : self_collisions(robot, bodies, options, turns).pairs)
    kinds[robot.bodies[pair.a].name + ' ' + robot.bodies[pair.b].name] = pair.kind;
  return kinds;
}

// A ball at 1 m from two hinges that turn by q1 and q2 touches one at the base's origin when the far one
// comes back: |1 + e^{iq2}| ≤ 0.4 where q2 is near π.
std::string folding_arm(const std::string& limits) {
  return robot_text(ball_link("base", 0.2) + ball_link("upper", 0.1, "0.5 0 0") +
                    ball_link("fore", 0.2, "1 0 0") +
                    hinge("base", "upper", "0 0 0", "lower='-1' upper='1'") +
                    hinge("upper", "fore", "1 0 0", limits));
}

TEST(SelfCollisions, OfAnArmThatFoldsBackAreSeen) {
  const auto kinds = kinds_of(robot_from(folding_arm("lower='-3.14' upper='3.14'")));
  EXPECT_EQ(kinds.at("base upper"), PairKind::kAdjacent);
  EXPECT_EQ(kinds.at("upper fore"), PairKind::kAdjacent);
  EXPECT_EQ(kinds.at("base fore"), PairKind::kSometimes);
}

TEST(SelfCollisions, OfAnArmThatCannotFoldBackAreNever) {
  // |1 + e^{iq}| = 2 |cos(q/2)| > 0.4 for |q| < 2 acos(0.2) = 2.7389
  const auto kinds = kinds_of(robot_from(folding_arm("lower='-2.73' upper='2.73'")));
  EXPECT_EQ(kinds.at("base fore"), PairKind::kNever);
}

TEST(SelfCollisions, AtRestAreDefaultAndRestIsTheMiddleWhereZeroIsNoPosition) {
  const auto kinds = kinds_of(robot_from(folding_arm("lower='2.9' upper='3.3'")));
  EXPECT_EQ(kinds.at("base fore"), PairKind::kDefault);
  const robot::Robot robot = robot_from(folding_arm("lower='2.9' upper='3.3'"));
  EXPECT_DOUBLE_EQ(rest_positions(robot)[1][0], 3.1);
}

TEST(SelfCollisions, AtNearlyEverySampleAreAlways) {
  // At rest they are apart (q = 0 is the only such place but for an interval of 2 % of the range).
  const std::string text =
      robot_text(ball_link("base", 0.2, "-1 0 0") + bare_link("a") + ball_link("b", 0.1) +
                 ball_link("c", 1.05, "0 0 2.2") +
                 hinge("base", "a", "0 0 0", "lower='0' upper='1'", "prismatic") +
                 hinge("a", "b", "0 0 0", "lower='0' upper='1'") +
                 hinge("b", "c", "0 0 -1.04", "lower='0' upper='0'"));
  // base at (-1,0,0) r 0.2; c at (0,0,1.16+q), r 1.05: distance² = 1 + (1.16+q)² > 1.25² always apart.
  EXPECT_EQ(kinds_of(robot_from(text)).at("base c"), PairKind::kNever);
  const std::string near = robot_text(
      ball_link("base", 0.5) + ball_link("mid", 0.01, "5 0 0") + ball_link("tip", 0.5, "0 0 1.01") +
      hinge("base", "mid", "0 0 0", "lower='-1' upper='0'", "prismatic") +
      hinge("mid", "tip", "0 0 0", "lower='-1' upper='1'"));
  // tip is at height 1.01 + q with q in [-1, 0]: apart only for q > -0.01.
  EXPECT_EQ(kinds_of(robot_from(near)).at("base tip"), PairKind::kAlways);
}

TEST(SelfCollisions, OfLinksBehindAFrameWithoutShapeAreAdjacent) {
  const auto kinds = kinds_of(robot_from(robot_text(
      ball_link("a", 1) + bare_link("flange") + ball_link("b", 1) + ball_link("c", 1) +
      hinge("a", "flange", "0 0 0", "", "fixed") + hinge("flange", "b", "0 0 0", "", "fixed") +
      hinge("flange", "c", "0 0 0", "", "fixed"))));
  EXPECT_EQ(kinds.size(), 3U);
  for (const auto& [names, kind] : kinds) EXPECT_EQ(kind, PairKind::kAdjacent) << names;
}

TEST(SelfCollisions, FollowTheLeadersOfFingers) {
  // Fingers at ±(0.1 + q): they meet at no q, but would if they moved alone.
  const auto finger = [](const std::string& name, const std::string& axis, const std::string& at,
                         const std::string& rest) {
    return "<joint name='j" + name + "' type='prismatic'><origin xyz='" + at +
           "'/><parent link='palm'/><child link='" + name + "'/><axis xyz='" + axis +
           "'/><limit effort='1' velocity='1' lower='-0.15' upper='0.15'/>" + rest + "</joint>";
  };
  const std::string links =
      ball_link("palm", 0.01, "0 0 1") + ball_link("l", 0.04) + ball_link("r", 0.04);
  const std::string alone = robot_text(links + finger("l", "1 0 0", "0.1 0 0", "") +
                                       finger("r", "1 0 0", "-0.1 0 0", ""));
  const std::string led = robot_text(links + finger("l", "1 0 0", "0.1 0 0", "") +
                                     finger("r", "1 0 0", "-0.1 0 0", "<mimic joint='jl'/>"));
  EXPECT_EQ(kinds_of(robot_from(alone)).at("l r"), PairKind::kSometimes);
  EXPECT_EQ(kinds_of(robot_from(led)).at("l r"), PairKind::kNever);
}

TEST(SelfCollisions, OfALinkWithAnUnknownShapeAreNotNever) {
  const std::string mesh =
      "<link name='fore'><collision><geometry><mesh "
      "filename='x.stl'/></geometry></collision></link>";
  const std::string text = robot_text(ball_link("base", 0.1) + ball_link("upper", 0.1) + mesh +
                                      hinge("base", "upper", "1 0 0", "lower='-1' upper='1'") +
                                      hinge("upper", "fore", "1 0 0", "lower='-1' upper='1'"));
  const robot::Robot robot = robot_from(text);
  EXPECT_EQ(kinds_of(robot).at("base fore"), PairKind::kSometimes);
  EXPECT_EQ(robot::CollisionBodies(robot, no_surface).unknown().size(), 1U);
}

TEST(SelfCollisions, AreTheSameForAnyNumberOfThreads) {
  const robot::Robot robot = robot_from(folding_arm("lower='-2.75' upper='2.75'"));
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const robot::SampleOptions options{.samples = 900, .seed = seed};
    EXPECT_EQ(kinds_of(robot, options, 1), kinds_of(robot, options, 4)) << seed;
  }
}

/// The eight corners of a cube of side 1 about the origin, and its twelve triangles.
std::shared_ptr<const mesh::TriangleMesh> cube_surface() {
  auto cube = std::make_shared<mesh::TriangleMesh>();
  for (unsigned i = 0; i < 8; ++i) {
    cube->positions.push_back(
        {(i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5, (i & 4U) != 0 ? 0.5 : -0.5});
  }
  for (const auto& [a, b, c, d] :
       {std::array{0U, 1U, 3U, 2U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
        std::array{2U, 3U, 7U, 6U}, std::array{0U, 2U, 6U, 4U}, std::array{1U, 3U, 7U, 5U}}) {
    cube->triangles.push_back({a, b, c});
    cube->triangles.push_back({a, c, d});
  }
  return cube;
}

TEST(Collider, TouchesWhereTheDistanceIsSmallerThanTheSizes) {
  using mesh::Collider;
  const auto at = [](double x) { return model::Pose{{x, 0, 0}, {}}; };
  const Collider ball = Collider::sphere(0.5), box = Collider::box({1, 1, 1});
  const Collider rod = Collider::cylinder(0.5, 3), pill = Collider::capsule(0.5, 1);
  const Collider cube = Collider::surface(*cube_surface(), {1, 1, 1});
  const Collider large = Collider::surface(*cube_surface(), {3, 3, 3});
  for (const Collider* other : {&ball, &box, &rod, &pill, &cube}) {
    EXPECT_TRUE(collide(ball, at(0), *other, at(0.999)));
    EXPECT_FALSE(collide(ball, at(0), *other, at(1.001)));
    EXPECT_TRUE(collide(*other, at(0), cube, at(0.999)));
    EXPECT_FALSE(collide(*other, at(0), cube, at(1.001)));
    EXPECT_TRUE(collide(large, at(0), *other, at(1.999)));
    EXPECT_FALSE(collide(large, at(0), *other, at(2.001)));
  }
  // A surface has no inside.
  EXPECT_FALSE(collide(large, at(0), cube, at(0)));
  // Turned by 45° a box reaches to √½.
  const model::Pose turned{{0, 0, 0}, model::from_axis_angle({0, 0, 1}, std::numbers::pi / 4)};
  EXPECT_TRUE(collide(box, turned, cube, at(0.5 + std::sqrt(0.5) - 1e-3)));
  EXPECT_FALSE(collide(box, turned, cube, at(0.5 + std::sqrt(0.5) + 1e-3)));
}

}  // namespace
}  // namespace rigor::test
