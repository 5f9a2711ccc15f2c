// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/joint/joint.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <rigor/convert/urdf/robot.h>
#include <rigor/model/frames.h>

#include "convert/converted.h"
#include "robot/robots.h"

namespace rigor::convert {
namespace {

using model::JointPositions;
using model::Pose;
using test::Converted;
using test::digits_of;
using test::sdf_joint;
using test::sdf_link;

std::string two_links(const std::string& type, const std::string& rest) {
  return sdf_link("a") + sdf_link("b", "0.3 -0.2 0.5 0.3 0.2 0.1") +
         sdf_joint("j", type, "a", "b", rest);
}

std::string axis(const std::string& xyz, const std::string& rest = {}) {
  return "<axis><xyz>" + xyz + "</xyz>" + rest + "</axis>";
}

std::string limit(const std::string& inside) { return "<limit>" + inside + "</limit>"; }

const std::string kBounds = "<lower>-1.50</lower><upper>1.50</upper>";
const std::string kStrength = "<effort>10</effort><velocity>2.0</velocity>";

TEST(UrdfJoint, CarriesLimitsAndDynamicsWithTheirDigits) {
  const Converted robot(two_links(
      "revolute", axis("0 1.0 0", limit(kBounds + kStrength) +
                                      "<dynamics><damping>0.10</damping><friction>.2</friction>"
                                      "</dynamics>")));
  const UrdfJoint& joint = robot.joint("j");
  EXPECT_EQ(joint.type, "revolute");
  EXPECT_EQ(digits_of(*joint.axis), "0 1.0 0");
  EXPECT_EQ(to_text(*joint.limit->lower), "-1.50");
  EXPECT_EQ(to_text(*joint.limit->upper), "1.50");
  EXPECT_EQ(to_text(joint.limit->effort), "10");
  EXPECT_EQ(to_text(joint.limit->velocity), "2.0");
  EXPECT_EQ(to_text(*joint.damping), "0.10");
  EXPECT_EQ(to_text(*joint.friction), ".2");
  EXPECT_TRUE(robot.notes(NoteKind::kEffortStandIn).empty());
}

TEST(UrdfJoint, ARevoluteWithoutLimitsIsContinuous) {
  for (const char* version : {"1.4", "1.9", "1.11"}) {
    const Converted robot(two_links("revolute", axis("0 0 1")), version);
    EXPECT_EQ(robot.joint("j").type, "continuous") << version;
    EXPECT_FALSE(robot.joint("j").limit) << version;
    EXPECT_EQ(robot.notes(NoteKind::kContinuous).size(), 1U) << version;
    EXPECT_TRUE(robot.notes(NoteKind::kEffortStandIn).empty()) << version;
  }
  const Converted strong(two_links("revolute", axis("0 0 1", limit(kStrength))));
  EXPECT_EQ(strong.joint("j").type, "continuous");
  EXPECT_EQ(to_text(strong.joint("j").limit->effort), "10");
  EXPECT_FALSE(strong.joint("j").limit->lower);
}

TEST(UrdfJoint, NothingInfiniteIsWritten) {
  const std::string endless[] = {
      "<lower>-inf</lower><upper>1</upper><effort>inf</effort><velocity>-1</velocity>",
      "<lower>-1e17</lower><upper>1</upper>", "<upper>1</upper><effort>-1</effort>",
      "<lower>nan</lower><upper>1</upper><effort>nan</effort>"};
  for (const char* type : {"revolute", "prismatic"}) {
    for (const std::string& inside : endless) {
      const Converted robot(two_links(type, axis("0 0 1", limit(inside))));
      const UrdfLimit& written = *robot.joint("j").limit;
      EXPECT_EQ(robot.joint("j").type, type);
      EXPECT_EQ(written.lower->value, -1e16) << inside;
      EXPECT_EQ(written.effort.value, 1e16) << inside;
      EXPECT_EQ(written.velocity.value, 1e16) << inside;
      EXPECT_EQ(robot.notes(NoteKind::kLimitStandIn).size(), 1U) << inside;
      EXPECT_EQ(robot.notes(NoteKind::kEffortStandIn).size(), 1U) << inside;
      const std::string text = urdf_text(*robot.result.robot);
      EXPECT_EQ(text.find("inf"), std::string::npos) << text;
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    }
  }
}

TEST(UrdfJoint, ZeroEffortIsNoLimitOnlyWhereItIsTheDefault) {
  const std::string model =
      two_links("prismatic", axis("0 0 1", limit(kBounds + "<effort>0</effort>"
                                                           "<velocity>1</velocity>")));
  EXPECT_EQ(Converted(model, "1.3").joint("j").limit->effort.value, 1e16);
  EXPECT_EQ(Converted(model, "1.4").joint("j").limit->effort.value, 0);
}

TEST(UrdfJoint, TheStandInIsTheUsersChoice) {
  UrdfOptions options;
  options.unlimited = 1000;
  const Converted robot(two_links("prismatic", axis("0 0 1")), "1.9", options);
  EXPECT_EQ(robot.joint("j").limit->upper->value, 1000);
  EXPECT_EQ(robot.joint("j").limit->velocity.value, 1000);
}

TEST(UrdfJoint, TellsLimitsThatAreInverted) {
  const Converted robot(
      two_links("revolute", axis("0 0 1", limit("<lower>1</lower><upper>-1</upper>" + kStrength))));
  ASSERT_EQ(robot.notes(NoteKind::kLimitInverted).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kLimitInverted)[0].written, "1 to -1");
}

TEST(UrdfJoint, AnAxisIsAUnitVectorInTheJointsFrame) {
  const Converted longer(two_links("revolute", axis("0 3 4")));
  EXPECT_EQ(digits_of(*longer.joint("j").axis), "0 0.6 0.8");
  EXPECT_EQ(longer.notes(NoteKind::kAxisUnit).size(), 1U);
  const Converted zero(two_links("revolute", axis("0 0 0")));
  EXPECT_EQ(digits_of(*zero.joint("j").axis), "0 0 1");
  EXPECT_EQ(zero.notes(NoteKind::kAxisZero).size(), 1U);
  EXPECT_EQ(Converted(two_links("revolute", "")).notes(NoteKind::kAxisZero).size(), 1U);
}

TEST(UrdfJoint, AnAxisIsReadInTheFrameOfItsVersion) {
  // The child is turned by a quarter about z: the model's x is its -y.
  const std::string model = sdf_link("a") + sdf_link("b", "0 0 0 0 0 1.5707963267948966") +
                            sdf_joint("j", "revolute", "a", "b", axis("1 0 0"));
  EXPECT_EQ(digits_of(*Converted(model, "1.4").joint("j").axis), "0 -1 0");
  EXPECT_EQ(digits_of(*Converted(model, "1.6").joint("j").axis), "1 0 0");
  EXPECT_EQ(digits_of(*Converted(model, "1.9").joint("j").axis), "1 0 0");
  const std::string flag = "<use_parent_model_frame>1</use_parent_model_frame>";
  const Converted flagged(sdf_link("a") + sdf_link("b", "0 0 0 0 0 1.5707963267948966") +
                              sdf_joint("j", "revolute", "a", "b", axis("1 0 0", flag)),
                          "1.6");
  EXPECT_EQ(digits_of(*flagged.joint("j").axis), "0 -1 0");
  const Converted expressed(sdf_link("a") + sdf_link("b", "0 0 0 0 0 1.5707963267948966") +
                            sdf_joint("j", "revolute", "a", "b",
                                      "<axis><xyz expressed_in='__model__'>1 0 0</xyz></axis>"));
  EXPECT_EQ(digits_of(*expressed.joint("j").axis), "0 -1 0");
}

TEST(UrdfJoint, ASecondAxisIsToldAndAFixedJointsAxisIsIdle) {
  const Converted two(two_links("revolute", axis("0 0 1") + "<axis2><xyz>1 0 0</xyz></axis2>"));
  ASSERT_EQ(two.notes(NoteKind::kSecondAxis).size(), 1U);
  EXPECT_EQ(two.notes(NoteKind::kSecondAxis)[0].count, 2U);
  const Converted fixed(two_links("fixed", axis("0 0 1")));
  EXPECT_FALSE(fixed.joint("j").axis);
  EXPECT_EQ(fixed.result.account.counts[static_cast<std::size_t>(Outcome::kLost)], 0U);
}

TEST(UrdfJoint, ATypeThatNobodyKnowsIsAnError) {
  for (const char* type : {"floating", "hinge"}) {
    const Converted robot(two_links(type, ""));
    EXPECT_EQ(robot.joint("j").type, "fixed");
    EXPECT_EQ(robot.notes(NoteKind::kJointTypeLost).size(), 1U) << type;
  }
}

// --- Motion: what moves in the SDF moves in the same way in the URDF, both by the model's own
// forward kinematics, which knows joints of either format but nothing of the conversion. ---

Pose relative(const model::Frames& frames, const model::Root& root, const std::string& from,
              const std::string& to) {
  std::optional<Pose> X_WA;
  std::optional<Pose> X_WB;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Id<model::Link> id{i};
    if (root[id].name.value == from) X_WA = frames.pose(id);
    if (root[id].name.value == to) X_WB = frames.pose(id);
  }
  return compose(inverse(X_WA.value()), X_WB.value());
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_NEAR(length(a.translation - b.translation), 0, 1e-12);
  const Pose apart = compose(inverse(a), b);
  EXPECT_NEAR(std::abs(apart.rotation.w), 1, 1e-12);
}

/// The child of `j` in both at these positions of its axes; its URDF frame is the SDF joint frame,
/// which is moved from the SDF link's by a fixed pose.
void expect_same_motion(const std::string& model, const std::vector<std::string>& names,
                        const std::array<double, 2>& q) {
  const Converted robot(model);
  const MemoryDisk disk({{"robot.urdf", urdf_text(robot.result.robot.value())}});
  const test::ReadRobot urdf(disk, "robot.urdf");
  const model::Root& sdf_root = robot.source.loaded.root;
  const Pose X_LJ = compose(inverse(*robot.source.frames.pose(model::Id<model::Link>{1})),
                            *robot.source.frames.pose(model::Id<model::Joint>{0}));

  JointPositions urdf_positions;
  for (std::size_t k = 0; k < names.size(); ++k) urdf_positions["m::" + names[k]] = {q[k], 0};
  const model::Frames moved_sdf(sdf_root, {{"m::j", q}});
  const model::Frames moved_urdf(urdf.loaded.root, urdf_positions);
  const Pose in_sdf = compose(relative(moved_sdf, sdf_root, "a", "b"), X_LJ);
  const Pose in_urdf = relative(moved_urdf, urdf.loaded.root, "a", "b");
  expect_same(in_sdf, in_urdf);
  // And it does move, all axes together.
  const Pose at_rest = relative(urdf.frames, urdf.loaded.root, "a", "b");
  EXPECT_GT(length(at_rest.translation - in_urdf.translation) +
                std::abs(1 - std::abs(compose(inverse(at_rest), in_urdf).rotation.w)),
            0.01);
}

const std::string kOffset = "<pose>0.1 0.2 -0.3 0.4 -0.2 0.7</pose>";
const std::string kBothAxes = axis("0 0.6 0.8") + "<axis2><xyz>1 0 0</xyz></axis2>";

TEST(UrdfJoint, JointsOfOneDegreeMoveAlike) {
  expect_same_motion(two_links("revolute", kOffset + axis("0 0.6 0.8")), {"j"}, {0.7, 0});
  expect_same_motion(two_links("prismatic", kOffset + axis("0 3 4")), {"j"}, {0.7, 0});
  expect_same_motion(two_links("continuous", kOffset + axis("1 0 0")), {"j"}, {-2.5, 0});
}

TEST(UrdfJoint, UniversalAndRevolute2AreTwoRevolutes) {
  for (const char* type : {"universal", "revolute2"}) {
    const std::string model = two_links(type, kOffset + kBothAxes);
    expect_same_motion(model, {"j", "j_axis2"}, {0.7, -1.1});
    const Converted robot(model);
    EXPECT_EQ(robot.result.joints.at("j"), (std::vector<std::string>{"j", "j_axis2"}));
    ASSERT_EQ(robot.notes(NoteKind::kJointType).size(), 1U);
    EXPECT_EQ(robot.notes(NoteKind::kJointType)[0].outcome, Outcome::kRewritten);
  }
}

double mass_of(const UrdfRobot& robot, const std::string& name) {
  for (const UrdfLink& link : robot.links) {
    if (link.name == name) return link.inertial ? link.inertial->mass.value : 0;
  }
  return -1;
}

/// A body with its center off its origin.
std::string heavy_link(const std::string& name, const std::string& mass) {
  return "<link name='" + name + "'><pose>0.3 -0.2 0.5 0.3 0.2 0.1</pose><inertial>" +
         "<pose>0.1 -0.2 0.3 0.5 0 0.4</pose><mass>" + mass +
         "</mass><inertia><ixx>0.03</ixx><ixy>0.001</ixy><iyy>0.04</iyy><izz>0.05</izz>"
         "</inertia></inertial></link>";
}

TEST(UrdfJoint, LinksBetweenHaveAMassThatWhatTheyCarryHasLess) {
  for (const std::string type : {"ball", "universal", "screw"}) {
    const std::string model = sdf_link("a") + heavy_link("b", "0.7") +
                              sdf_joint("j", type, "a", "b", kOffset + kBothAxes);
    const Converted converted(model);
    const UrdfRobot& robot = *converted.result.robot;
    // libsdformat takes 1e-6 for nothing, MuJoCo 1e-15.
    const std::size_t count = type == "ball" ? 2 : 1;
    std::size_t between = 0;
    for (const UrdfLink& link : robot.links) {
      if (!link.name.starts_with("j_")) continue;
      ++between;
      EXPECT_GT(link.inertial->mass.value, 1.5e-6);
      for (const std::size_t i : {0U, 3U, 5U}) EXPECT_GT(link.inertial->inertia[i].value, 2e-15);
    }
    EXPECT_EQ(between, count) << type;
    EXPECT_NEAR(mass_of(robot, "b"), 0.7 - 2e-6 * static_cast<double>(count), 1e-15);
    ASSERT_EQ(converted.notes(NoteKind::kLinkBetween).size(), 1U);
    EXPECT_EQ(converted.notes(NoteKind::kLinkBetween)[0].count, count);
    EXPECT_EQ(converted.notes(NoteKind::kLinkBetween)[0].outcome, Outcome::kSubstituted);

    // All bodies together, at joint positions drawn at random, far within what a comparison lets pass.
    const robot::Robot before =
        test::robot_from("<sdf version='1.9'><model name='m'>" + model + "</model></sdf>");
    const robot::Robot after = test::robot_from(urdf_text(robot));
    std::mt19937 random(7);
    for (int round = 0; round < 10; ++round) {
      std::map<std::string, double> drawn;
      const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
      for (const std::string name : {"j", "j_axis2", "j_axis3"}) drawn[name] = draw();
      robot::Positions q{{}}, p;
      for (std::size_t k = 0; k < before.joints[0].axes.size(); ++k) {
        q[0].push_back(drawn[k == 0 ? "j" : "j_axis" + std::to_string(k + 1)]);
      }
      for (const robot::Joint& joint : after.joints) p.push_back({drawn[joint.name]});
      const robot::Moments x = moments(before, body_poses(before, q));
      const robot::Moments y = moments(after, body_poses(after, followed(after, p)));
      EXPECT_NEAR(x.mass, y.mass, 1e-14);
      EXPECT_NEAR(length(x.first - y.first), 0, 1e-14);
      EXPECT_NEAR(x.second.ixx, y.second.ixx, 1e-13);
      EXPECT_NEAR(x.second.iyz, y.second.iyz, 1e-13);
      EXPECT_NEAR(x.second.izz, y.second.izz, 1e-13);
    }
  }
}

TEST(UrdfJoint, WhatWeighsNextToNothingItselfGivesNothing) {
  const Converted robot(sdf_link("a") + heavy_link("b", "0.0001") +
                        sdf_joint("j", "universal", "a", "b", kBothAxes));
  EXPECT_EQ(mass_of(*robot.result.robot, "b"), 0.0001);
  EXPECT_EQ(mass_of(*robot.result.robot, "j_axis2_link"), 0);
  EXPECT_TRUE(robot.notes(NoteKind::kLinkBetween).empty());
}

TEST(UrdfJoint, ABallIsThreeTurnsThatReachEveryRotation) {
  const Converted robot(two_links("ball", kOffset));
  EXPECT_EQ(digits_of(*robot.joint("j").axis), "0 0 1");
  EXPECT_EQ(digits_of(*robot.joint("j_axis2").axis), "0 1 0");
  EXPECT_EQ(digits_of(*robot.joint("j_axis3").axis), "1 0 0");
  EXPECT_EQ(robot.joint("j_axis3").child, "b");
  EXPECT_TRUE(is_identity(robot.joint("j_axis2").origin));
  ASSERT_EQ(robot.notes(NoteKind::kJointType).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kJointType)[0].outcome, Outcome::kSubstituted);
}

TEST(UrdfJoint, AScrewSlidesAsItTurns) {
  // 1.9: radians per meter of a left-handed thread.
  const Converted old(
      two_links("screw", axis("0 0 1", limit(kBounds)) + "<thread_pitch>-20</thread_pitch>"));
  const UrdfJoint& slide = old.joint("j_slide");
  EXPECT_EQ(slide.type, "prismatic");
  EXPECT_EQ(slide.mimic->joint, "j");
  EXPECT_EQ(to_text(slide.mimic->multiplier), "0.05");
  EXPECT_EQ(to_text(*slide.limit->upper), "0.075");
  // 1.10: meters per turn of a right-handed one.
  const Converted now(
      two_links("screw", axis("0 0 1") + "<screw_thread_pitch>0.5</screw_thread_pitch>"), "1.11");
  EXPECT_DOUBLE_EQ(now.joint("j_slide").mimic->multiplier.value, 0.5 / (2 * std::acos(-1.0)));
  EXPECT_EQ(now.result.account.counts[static_cast<std::size_t>(Outcome::kLost)], 0U);
}

std::string follower(const std::string& mimic) {
  return sdf_link("a") + sdf_link("b") + sdf_link("c") +
         sdf_joint("j", "revolute", "a", "b", axis("0 0 1")) +
         sdf_joint("k", "revolute", "a", "c", axis("0 0 1", mimic));
}

TEST(UrdfJoint, AMimicsReferenceIsFoldedIntoTheOffset) {
  const Converted robot(follower("<mimic joint='j'><multiplier>2.0</multiplier><offset>0.5</offset>"
                                 "<reference>0.25</reference></mimic>"),
                        "1.11");
  const UrdfMimic& mimic = *robot.joint("k").mimic;
  EXPECT_EQ(mimic.joint, "j");
  EXPECT_EQ(to_text(mimic.multiplier), "2.0");
  EXPECT_EQ(mimic.offset.value, 0);  // 0.5 - 2·0.25
  ASSERT_EQ(robot.notes(NoteKind::kMimicReference).size(), 1U);
  EXPECT_EQ(robot.result.account.counts[static_cast<std::size_t>(Outcome::kLost)], 0U);
}

TEST(UrdfJoint, AMimicWithoutALeaderIsLost) {
  for (const char* leader : {"nobody", "k"}) {
    const Converted robot(follower("<mimic joint='" + std::string(leader) + "'/>"), "1.11");
    EXPECT_FALSE(robot.joint("k").mimic);
    ASSERT_EQ(robot.notes(NoteKind::kMimicLost).size(), 1U) << leader;
  }
  const Converted circle(
      sdf_link("a") + sdf_link("b") + sdf_link("c") +
          sdf_joint("j", "revolute", "a", "b", axis("0 0 1", "<mimic joint='k'/>")) +
          sdf_joint("k", "revolute", "a", "c", axis("0 0 1", "<mimic joint='j'/>")),
      "1.11");
  EXPECT_TRUE(circle.joint("j").mimic);
  EXPECT_FALSE(circle.joint("k").mimic);
  ASSERT_EQ(circle.notes(NoteKind::kMimicLost).size(), 1U);
  EXPECT_EQ(circle.notes(NoteKind::kMimicLost)[0].instead, "k → j → k is a ring, cut at k");
}

TEST(UrdfJoint, WhoFollowsAFollowerFollowsItsLeader) {
  const auto mimic = [](const std::string& rest) { return axis("0 0 1", rest); };
  const Converted robot(
      sdf_link("a") + sdf_link("b") + sdf_link("c") + sdf_link("d") +
          // In the file before those that it follows.
          sdf_joint("l", "revolute", "a", "d",
                    mimic("<mimic joint='k'><multiplier>-2</multiplier><offset>0.1</offset>"
                          "<reference>1</reference></mimic>")) +
          sdf_joint("k", "revolute", "a", "c",
                    mimic("<mimic joint='j'><multiplier>0.5</multiplier><offset>0.25</offset>"
                          "</mimic>")) +
          sdf_joint("j", "revolute", "a", "b", mimic("")),
      "1.11");
  EXPECT_EQ(robot.joint("k").mimic->joint, "j");
  EXPECT_EQ(to_text(robot.joint("k").mimic->multiplier), "0.5");
  // l = -2 (k - 1) + 0.1 = -2 (0.5 j + 0.25) + 2.1 = -j + 1.6
  EXPECT_EQ(robot.joint("l").mimic->joint, "j");
  EXPECT_EQ(to_text(robot.joint("l").mimic->multiplier), "-1");
  EXPECT_DOUBLE_EQ(robot.joint("l").mimic->offset.value, 1.6);
  ASSERT_EQ(robot.notes(NoteKind::kMimicChain).size(), 1U);
  const Note note = robot.notes(NoteKind::kMimicChain)[0];
  EXPECT_EQ(note.outcome, Outcome::kRewritten);
  EXPECT_EQ(robot.text_at(note), "k");
  EXPECT_EQ(note.instead, "j");
}

TEST(UrdfJoint, AScrewThatFollowsTakesItsSlideAlong) {
  const Converted robot(
      sdf_link("a") + sdf_link("b") + sdf_link("c") +
          sdf_joint("j", "revolute", "a", "b", axis("0 0 1")) +
          sdf_joint("k", "screw", "a", "c",
                    axis("0 0 1", "<mimic joint='j'><multiplier>3</multiplier></mimic>") +
                        "<thread_pitch>-20</thread_pitch>"),
      "1.11");
  EXPECT_EQ(robot.joint("k").mimic->joint, "j");
  EXPECT_EQ(robot.joint("k_slide").mimic->joint, "j");
  EXPECT_EQ(to_text(robot.joint("k_slide").mimic->multiplier), "0.15");  // 3 / 20
}

std::string gearbox(const std::string& name, const std::string& parent, const std::string& child,
                    const std::string& ratio) {
  return sdf_joint(name, "gearbox", parent, child,
                   axis("0 0 1") + "<axis2><xyz>0 0 1</xyz></axis2><gearbox_ratio>" + ratio +
                       "</gearbox_ratio><gearbox_reference_body>frame</gearbox_reference_body>");
}

TEST(UrdfJoint, AGearboxOnAJointThatIsTurnedRound) {
  // The frame hangs on the base, so that joint i, which leads from wheel a to it, is turned: its angle q
  // is that of the frame in a, and a stands at θ_a = -q in the frame. θ_b = -3 θ_a = 3 q.
  const Converted robot(sdf_link("base") + sdf_link("frame") + sdf_link("a") +
                        sdf_link("b", "0 1 0 0 0 0") + sdf_joint("weld", "fixed", "base", "frame") +
                        sdf_joint("i", "revolute", "a", "frame", axis("0 0 1")) +
                        sdf_joint("j", "revolute", "frame", "b", axis("0 0 1")) +
                        gearbox("g", "a", "b", "3"));
  EXPECT_EQ(robot.joint("i").parent, "frame");
  EXPECT_EQ(digits_of(*robot.joint("i").axis), "0 0 -1");
  ASSERT_TRUE(robot.joint("j").mimic);
  EXPECT_EQ(robot.joint("j").mimic->joint, "i");
  EXPECT_EQ(robot.joint("j").mimic->multiplier.value, 3);
}

TEST(UrdfJoint, AGearboxIsAMimic) {
  const auto gears = [](const std::string& second_axis) {
    return sdf_link("frame") + sdf_link("a") + sdf_link("b", "0 1 0 0 0 0") +
           sdf_joint("i", "revolute", "frame", "a", axis("0 0 1")) +
           sdf_joint("j", "revolute", "frame", "b", axis(second_axis)) +
           gearbox("g", "a", "b", "3");
  };
  // θ_b = -3 θ_a about the gearbox's axes; a joint about the opposite one counts backwards.
  EXPECT_EQ(Converted(gears("0 0 1")).joint("j").mimic->multiplier.value, -3);
  EXPECT_EQ(Converted(gears("0 0 -1")).joint("j").mimic->multiplier.value, 3);
  // In a train the last wheel follows the first: θ_c = -2 θ_b = 6 θ_a.
  const Converted train(sdf_link("frame") + sdf_link("a") + sdf_link("b", "0 1 0 0 0 0") +
                        sdf_link("c", "0 2 0 0 0 0") +
                        sdf_joint("i", "revolute", "frame", "a", axis("0 0 1")) +
                        sdf_joint("j", "revolute", "frame", "b", axis("0 0 1")) +
                        sdf_joint("k", "revolute", "frame", "c", axis("0 0 1")) +
                        gearbox("g", "a", "b", "3") + gearbox("h", "b", "c", "2"));
  EXPECT_EQ(train.joint("k").mimic->joint, "i");
  EXPECT_EQ(train.joint("k").mimic->multiplier.value, 6);
  const Converted skew(gears("1 0 0"));
  EXPECT_FALSE(skew.joint("j").mimic);
  EXPECT_EQ(skew.notes(NoteKind::kJointTypeLost).size(), 1U);
}

}  // namespace
}  // namespace rigor::convert
