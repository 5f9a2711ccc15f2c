// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "convert/mjcf_converted.h"

namespace rigor::test {
namespace {

using convert::MjcfActuators;
using convert::NoteKind;

std::string two_links(const std::string& type, const std::string& axes,
                      const std::string& rest = {}) {
  return mjcf_link("base") + mjcf_link("tip") + "<joint name='j' type='" + type +
         "'><parent>base</parent><child>tip</child>" + axes + "</joint>" + rest;
}

std::string mjcf_axis(const std::string& inside, const std::string& xyz = "0 0 1") {
  return "<axis><xyz>" + xyz + "</xyz>" + inside + "</axis>";
}

TEST(MjcfJoint, HingeHasRangeAndDynamicsOfItsAxis) {
  const MjcfConverted arm(
      two_links("revolute",
                mjcf_axis("<limit><lower>-1.5</lower><upper>0.25</upper><effort>30</effort></limit>"
                          "<dynamics><damping>0.7</damping><friction>0.2</friction>"
                          "<spring_stiffness>4</spring_stiffness>"
                          "<spring_reference>0.1</spring_reference></dynamics>",
                          "0 2 0")));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  const xml::Element joint = arm.named("joint", "j");
  EXPECT_EQ(MjcfConverted::attribute(joint, "axis"), "0 1 0");
  EXPECT_EQ(MjcfConverted::attribute(joint, "limited"), "true");
  EXPECT_EQ(MjcfConverted::attribute(joint, "range"), "-1.5 0.25");
  EXPECT_EQ(MjcfConverted::attribute(joint, "damping"), "0.7");
  EXPECT_EQ(MjcfConverted::attribute(joint, "frictionloss"), "0.2");
  EXPECT_EQ(MjcfConverted::attribute(joint, "stiffness"), "4");
  EXPECT_EQ(MjcfConverted::attribute(joint, "springref"), "0.1");
  EXPECT_EQ(arm.attribute("motor", "j", "ctrlrange"), "-30 30");
}

TEST(MjcfJoint, ContinuousAndHalfLimitedJointsAreToldApart) {
  const MjcfConverted wheel(two_links("continuous", mjcf_axis("")));
  EXPECT_EQ(wheel.attribute("joint", "j", "range"), "(none)");
  const MjcfConverted ratchet(two_links("prismatic", mjcf_axis("<limit><lower>0</lower></limit>")));
  EXPECT_EQ(ratchet.attribute("joint", "j", "type"), "slide");
  EXPECT_EQ(ratchet.attribute("joint", "j", "range"), "0 10000000000");
  EXPECT_EQ(ratchet.errors(), std::vector<std::string>());
}

TEST(MjcfJoint, ALimitThatIsFarOffStaysOne) {
  const MjcfConverted wheel(
      two_links("revolute", mjcf_axis("<limit><lower>-1e12</lower><upper>1e12</upper></limit>")));
  EXPECT_EQ(wheel.attribute("joint", "j", "range"), "-1000000000000 1000000000000");
  EXPECT_EQ(wheel.errors(), std::vector<std::string>());
}

TEST(MjcfJoint, LockedJointIsHeldByAnEquality) {
  const MjcfConverted arm(
      two_links("revolute", mjcf_axis("<limit><lower>0.5</lower><upper>0.5</upper></limit>")));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("joint", "j", "range"), "(none)");
  const xml::Element equality = arm.all("equality").at(0).children().begin().operator*();
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint1"), "j");
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint2"), "(none)");
  EXPECT_EQ(MjcfConverted::attribute(equality, "polycoef"), "0.5 0 0 0 0");
  EXPECT_EQ(arm.attribute("key", "home", "qpos"), "0 0 0 1 0 0 0 0.5");
  EXPECT_EQ(arm.notes(NoteKind::kMjcfLocked).size(), 1U);
}

TEST(MjcfJoint, JointsOfSeveralDegreesAreJointsOfOneBody) {
  const MjcfConverted arm(
      two_links("universal", mjcf_axis("", "1 0 0") + "<axis2><xyz>0 1 0</xyz></axis2>"));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("joint", "j", "axis"), "1 0 0");
  EXPECT_EQ(arm.attribute("joint", "j_axis2", "axis"), "0 1 0");
  EXPECT_EQ(arm.named("joint", "j").parent(), arm.named("joint", "j_axis2").parent());
  const MjcfConverted ball(two_links("ball", ""));
  EXPECT_EQ(ball.attribute("joint", "j", "type"), "ball");
  EXPECT_EQ(ball.errors(), std::vector<std::string>());
}

std::string spherical_arm(const std::string& rest) {
  const auto link = [](const std::string& name) {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' "
           "izz='0.1'/></inertial></link>";
  };
  return "<robot name='r'>" + link("base") + link("tip") +
         "<joint name='j' type='spherical'><parent link='base'/><child link='tip'/>"
         "<origin xyz='0 0 1'/>" +
         rest + "</joint></robot>";
}

TEST(MjcfJoint, SphericalJointOfBulletsUrdfIsABall) {
  const MjcfConverted arm(spherical_arm(""));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("joint", "j", "type"), "ball");
  EXPECT_EQ(arm.attribute("body", "tip", "pos"), "0 0 1");
  EXPECT_EQ(arm.named("joint", "j").parent(), arm.named("body", "tip"));
  // A free root and a ball: seven numbers and four.
  EXPECT_EQ(arm.attribute("key", "home", "qpos"), "0 0 0 1 0 0 0 1 0 0 0");
  const auto told = arm.notes(NoteKind::kJointDialect);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].written, "spherical");
  EXPECT_EQ(told[0].instead, "ball");
}

TEST(MjcfJoint, SphericalJointHasNoAxis) {
  const MjcfConverted arm(spherical_arm("<axis xyz='0 0 1'/><foo/>"));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("joint", "j", "axis"), "(none)");
  const auto idle = arm.notes(NoteKind::kIdle);
  ASSERT_EQ(idle.size(), 1U);
  EXPECT_EQ(idle[0].written, "axis of a spherical joint");
  EXPECT_EQ(arm.notes(NoteKind::kMjcfLost).size(), 1U) << "foo";
}

/// SDF 1.9: `<thread_pitch>` is rad/m of a left-handed thread, so a turn by 1 rad moves by -1/pitch.
TEST(MjcfJoint, ScrewSlidesWithItsTurn) {
  const MjcfConverted arm(two_links("screw", "<thread_pitch>-4</thread_pitch>" + mjcf_axis("")));
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("joint", "j_slide", "type"), "slide");
  const xml::Element equality = arm.all("equality").at(0).children().begin().operator*();
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint1"), "j_slide");
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint2"), "j");
  EXPECT_EQ(MjcfConverted::attribute(equality, "polycoef"), "0 0.25 0 0 0");
}

constexpr const char* kGripper = R"(<robot name="g">
  <link name="palm"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="left"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="right"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="l" type="prismatic"><parent link="palm"/><child link="left"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.04" effort="20" velocity="0.2"/></joint>
  <joint name="r" type="prismatic"><parent link="palm"/><child link="right"/><axis xyz="0 1 0"/>
    <limit lower="-0.05" upper="0.05" effort="20" velocity="0.2"/><mimic joint="l" multiplier="-1" offset="0.01"/></joint>
</robot>)";

TEST(MjcfJoint, FollowerIsCoupledAndHasNoActuator) {
  const MjcfConverted gripper(kGripper);
  ASSERT_EQ(gripper.errors(), std::vector<std::string>());
  const xml::Element equality = gripper.all("equality").at(0).children().begin().operator*();
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint1"), "r");
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint2"), "l");
  EXPECT_EQ(MjcfConverted::attribute(equality, "polycoef"), "0.01 -1 0 0 0");
  EXPECT_EQ(gripper.all("motor").size(), 1U);
  EXPECT_EQ(gripper.attribute("key", "home", "qpos"), "0 0 0 1 0 0 0 0 0.01");
}

/// θ_child = -ratio · θ_parent, both seen from the reference body.
TEST(MjcfJoint, GearboxIsAnEqualityOfTheJointsThatItCouples) {
  const auto gears = [](const std::string& reference) {
    const auto joint = [](const std::string& name, const std::string& type, const std::string& ends,
                          const std::string& rest) {
      return "<joint name='" + name + "' type='" + type + "'>" + ends + mjcf_axis("") + rest +
             "</joint>";
    };
    return mjcf_link("frame") + mjcf_link("a") + mjcf_link("b") +
           joint("i", "revolute", "<parent>frame</parent><child>a</child>", "") +
           joint("j", "revolute", "<parent>frame</parent><child>b</child>", "") +
           joint("g", "gearbox", "<parent>a</parent><child>b</child>",
                 "<axis2><xyz>0 0 1</xyz></axis2><gearbox_ratio>3</gearbox_ratio>"
                 "<gearbox_reference_body>" +
                     reference + "</gearbox_reference_body>");
  };
  const MjcfConverted geared(gears("frame"));
  ASSERT_EQ(geared.errors(), std::vector<std::string>());
  EXPECT_EQ(geared.all("joint").size(), 3U);  // i, j, and the equality
  const xml::Element equality = geared.all("equality").at(0).children().begin().operator*();
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint1"), "j");
  EXPECT_EQ(MjcfConverted::attribute(equality, "joint2"), "i");
  EXPECT_EQ(MjcfConverted::attribute(equality, "polycoef"), "0 -3 0 0 0");
  EXPECT_EQ(geared.notes(NoteKind::kMjcfJointType).size(), 1U);
  const MjcfConverted lost(gears("a"), {}, author::Losses::kAllowed);
  EXPECT_EQ(lost.notes(NoteKind::kJointTypeLost).size(), 1U);
}

TEST(MjcfJoint, AJointOfNoKnownTypeHoldsItsChildAndIsNamedByNothing) {
  const MjcfConverted arm(
      two_links("hinge", mjcf_axis("<limit><lower>0</lower><upper>0</upper></limit>")), {},
      author::Losses::kAllowed);
  EXPECT_EQ(arm.notes(NoteKind::kJointTypeLost).size(), 1U);
  EXPECT_TRUE(arm.all("joint").empty());
  EXPECT_TRUE(arm.all("equality").empty());
}

TEST(MjcfJoint, ActuatorsGiveTheEffortWhateverTheirKind) {
  const MjcfConverted position(kGripper, {.actuators = MjcfActuators::kPosition});
  EXPECT_EQ(position.attribute("position", "l", "ctrlrange"), "0 0.04");
  EXPECT_EQ(position.attribute("position", "l", "forcerange"), "-20 20");
  EXPECT_EQ(position.attribute("position", "l", "kp"), "200");  // 20 N at 0.1 m
  const MjcfConverted velocity(kGripper, {.actuators = MjcfActuators::kVelocity});
  EXPECT_EQ(velocity.attribute("velocity", "l", "ctrlrange"), "-0.2 0.2");
  EXPECT_EQ(velocity.notes(NoteKind::kMjcfVelocity).size(), 0U);
  const MjcfConverted none(kGripper, {.actuators = MjcfActuators::kNone});
  EXPECT_EQ(none.all("actuator").size(), 0U);
  EXPECT_EQ(none.notes(NoteKind::kMjcfEffort).size(), 2U);
  const auto lost = position.notes(NoteKind::kMjcfEffort);  // of the one that follows
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].written, "20");
  EXPECT_NE(lost[0].subject.find("joint r"), std::string::npos) << lost[0].subject;
}

TEST(MjcfJoint, LoopIsClosedByTwoPointsOfItsAxis) {
  const auto revolute = [](const std::string& name, const std::string& parent,
                           const std::string& child) {
    return "<joint name='" + name + "' type='revolute'><parent>" + parent + "</parent><child>" +
           child + "</child>" + mjcf_axis("") + "</joint>";
  };
  const MjcfConverted bars(mjcf_link("a") + mjcf_link("b") + mjcf_link("c") +
                           revolute("ab", "a", "b") + revolute("bc", "b", "c") +
                           revolute("ac", "a", "c"));
  ASSERT_EQ(bars.errors(), std::vector<std::string>());
  const auto connects = bars.all("connect");
  ASSERT_EQ(connects.size(), 2U);
  EXPECT_EQ(MjcfConverted::attribute(connects[0], "body1"), "a");
  EXPECT_EQ(MjcfConverted::attribute(connects[0], "body2"), "c");
  EXPECT_EQ(MjcfConverted::attribute(connects[0], "anchor"), "0 0 0");
  EXPECT_EQ(MjcfConverted::attribute(connects[1], "anchor"), "0 0 0.1");
}

TEST(MjcfJoint, InvertedLimitsAndAxesWithoutDirectionAreErrors) {
  const MjcfConverted inverted(
      two_links("revolute", mjcf_axis("<limit><lower>1</lower><upper>-1</upper></limit>")));
  EXPECT_EQ(inverted.errors().size(), 1U);
  EXPECT_TRUE(inverted.errors().at(0).starts_with("convert-limit-inverted"));
}

}  // namespace
}  // namespace rigor::test
