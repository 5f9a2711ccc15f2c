// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf_joint.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/urdf_robot.h>
#include <rigor/model/frames.h>

#include "convert/converted.h"

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
  // 1.9: radians per metre of a left-handed thread.
  const Converted old(
      two_links("screw", axis("0 0 1", limit(kBounds)) + "<thread_pitch>-20</thread_pitch>"));
  const UrdfJoint& slide = old.joint("j_slide");
  EXPECT_EQ(slide.type, "prismatic");
  EXPECT_EQ(slide.mimic->joint, "j");
  EXPECT_EQ(to_text(slide.mimic->multiplier), "0.05");
  EXPECT_EQ(to_text(*slide.limit->upper), "0.075");
  // 1.10: metres per turn of a right-handed one.
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
}

TEST(UrdfJoint, AGearboxIsAMimic) {
  const auto gears = [](const std::string& second_axis) {
    return sdf_link("frame") + sdf_link("a") + sdf_link("b", "0 1 0 0 0 0") +
           sdf_joint("i", "revolute", "frame", "a", axis("0 0 1")) +
           sdf_joint("j", "revolute", "frame", "b", axis(second_axis)) +
           sdf_joint("g", "gearbox", "a", "b",
                     axis("0 0 1") +
                         "<axis2><xyz>0 0 1</xyz></axis2><gearbox_ratio>3</gearbox_ratio>"
                         "<gearbox_reference_body>frame</gearbox_reference_body>");
  };
  // θ_b = -3 θ_a about the gearbox's axes; a joint about the opposite one counts backwards.
  EXPECT_EQ(Converted(gears("0 0 1")).joint("j").mimic->multiplier.value, -3);
  EXPECT_EQ(Converted(gears("0 0 -1")).joint("j").mimic->multiplier.value, 3);
  const Converted skew(gears("1 0 0"));
  EXPECT_FALSE(skew.joint("j").mimic);
  EXPECT_EQ(skew.notes(NoteKind::kJointTypeLost).size(), 1U);
}

}  // namespace
}  // namespace rigor::convert
