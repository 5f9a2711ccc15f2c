// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// attach: the text that comes out, and poses composed by hand.

#include <rigor/author/verbs/attach.h>

#include <gtest/gtest.h>

#include <rigor/author/verbs/attach_macro.h>
#include <rigor/author/verbs/remove.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kCarrierArm = R"(<robot name="arm">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base"/>
  <joint name="j" type="fixed">
    <origin xyz="0 0 1"/><parent link="base"/><child link="tool"/>
  </joint>
  <link name="tool"/>
</robot>
)";

constexpr const char* kJaws = R"(<robot name="jaws">
	<!-- two fingers -->
	<material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
	<link name="base">
		<visual><geometry><mesh filename="meshes/base.stl"/></geometry><material name="grey"/></visual>
	</link>
	<joint name="j" type="prismatic">
		<origin xyz="0 0.1 0"/><parent link="base"/><child link="finger"/>
		<axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/>
	</joint>
	<link name="finger"/>
</robot>
)";

TEST(Attach, NamespacesOfTheCopy) {
  const std::string hand =
      "<robot name='hand' xmlns:drake='http://drake.mit.edu' "
      "xmlns:gz='http://gazebosim.org/schema' "
      "xmlns:unused='http://example.org'>\n"
      "  <link name='palm'><collision><geometry><box size='1 1 1'/></geometry>"
      "<drake:proximity_properties gz:of='palm' xml:lang='en'/></collision>"
      "<own:note xmlns:own='http://example.org/own'/></link>\n</robot>\n";
  const std::string root = "<robot name='arm' xmlns:gz='http://ignitionrobotics.org/schema'>\n";
  VerbBench bench({{"arm.urdf", root + "  <link name='base'/>\n</robot>\n"}, {"hand.urdf", hand}});
  const EditedModel& arm = bench.open("arm.urdf");
  AttachRequest request;
  request.link = "base";
  const Change change = attached(bench.reader(), arm, bench.open("hand.urdf"), request);
  const std::string text = bench.text(arm, change);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "<robot name='arm' xmlns:gz='http://ignitionrobotics.org/schema' "
            "xmlns:drake='http://drake.mit.edu'>");
  ASSERT_EQ(change.notes.size(), 1U);
  EXPECT_EQ(change.notes[0],
            "namespace prefix 'gz' is http://ignitionrobotics.org/schema as in arm.urdf, not "
            "http://gazebosim.org/schema as in hand.urdf");
}

TEST(Attach, NamespacesOfANestedModel) {
  VerbBench bench(
      {{"arm.sdf",
        "<sdf version='1.9'>\n  <model name='arm'>\n    <link name='base'/>\n  </model>\n</sdf>\n"},
       {"hand.sdf",
        "<sdf version='1.9' xmlns:gz='http://gazebosim.org/schema'>\n  <model name='hand'>\n"
        "    <link name='palm' gz:of='x'/>\n  </model>\n</sdf>\n"}});
  const EditedModel& arm = bench.open("arm.sdf");
  AttachRequest request;
  request.link = "base";
  for (const AttachBy by : {AttachBy::kCopy, AttachBy::kInclude}) {
    request.by = by;
    const std::string text =
        bench.text(arm, attached(bench.reader(), arm, bench.open("hand.sdf"), request));
    EXPECT_EQ(text.substr(0, text.find('\n')),
              by == AttachBy::kCopy ? "<sdf version='1.9' xmlns:gz='http://gazebosim.org/schema'>"
                                    : "<sdf version='1.9'>");
  }
}

TEST(Attach, AUrdfWithTakenNames) {
  VerbBench bench({{"arm/arm.urdf", kCarrierArm}, {"jaws/jaws.urdf", kJaws}});
  const EditedModel& arm = bench.open("arm/arm.urdf");
  const EditedModel& jaws = bench.open("jaws/jaws.urdf");
  AttachRequest request;
  request.link = "tool";
  request.X_LG = {{0, 0, 0.25}, {}};
  const std::string text = bench.text(arm, attached(bench.reader(), arm, jaws, request));
  const std::string source = kCarrierArm;
  EXPECT_EQ(text, source.substr(0, source.find("</robot>")) +
                      R"(  <joint name="tool_to_jaws" type="fixed">
    <origin xyz="0 0 0.25" rpy="0 0 0"/>
    <parent link="tool"/>
    <child link="jaws_base"/>
  </joint>
	<!-- two fingers -->
	<link name="jaws_base">
		<visual><geometry><mesh filename="../jaws/meshes/base.stl"/></geometry><material name="grey"/></visual>
	</link>
	<joint name="jaws_j" type="prismatic">
		<origin xyz="0 0.1 0"/><parent link="jaws_base"/><child link="jaws_finger"/>
		<axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="1" velocity="1"/>
	</joint>
	<link name="jaws_finger"/>
</robot>
)");
  const EditedModel& whole = bench.open_text("arm/arm.urdf", text);
  const auto finger = whole.robot.bodies[whole.body_index("jaws_finger")].X_MB.translation;
  EXPECT_EQ(finger, (model::Vector3{0, 0.1, 1.25}));
  const std::string back = bench.text(whole, removed(whole, "jaws_base", Subtree::kRemoved, {}));
  EXPECT_EQ(VerbBench::words(
                differences_at_rounding(arm.robot, bench.open_text("arm/arm.urdf", back).robot)),
            "");
}

std::string with_hardware(const std::string& robot, const std::string& joint) {
  return "<robot name=\"" + robot + "\">\n  <link name=\"" + robot + "_a\"/><link name=\"" + robot +
         "_b\"/>\n  <joint name=\"" + joint + "\" type=\"continuous\"><parent link=\"" + robot +
         "_a\"/><child link=\"" + robot +
         "_b\"/></joint>\n"
         "  <ros2_control name=\"sys\" type=\"system\"><joint name=\"" +
         joint +
         "\"/><sensor name=\"ft\"/></ros2_control>\n"
         "  <transmission name=\"" +
         robot + "_t\"><joint name=\"" + joint +
         "\"/><actuator name=\"motor\"/></transmission>\n</robot>\n";
}

/// controller_manager rejects two pieces of hardware of one name.
TEST(Attach, HardwareOfTheCopyHasNamesOfItsOwn) {
  VerbBench bench({{"arm.urdf", with_hardware("arm", "elbow")},
                   {"hand.urdf", with_hardware("hand", "knuckle")}});
  const EditedModel& arm = bench.open("arm.urdf");
  const EditedModel& hand = bench.open("hand.urdf");
  AttachRequest request;
  request.link = "arm_b";
  const auto expect = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  };
  // Without a prefix, only what is taken.
  const std::string taken = bench.text(arm, attached(bench.reader(), arm, hand, request));
  expect(taken,
         "<ros2_control name=\"hand_sys\" type=\"system\"><joint name=\"knuckle\"/>"
         "<sensor name=\"hand_ft\"/></ros2_control>");
  expect(taken,
         "<transmission name=\"hand_t\"><joint name=\"knuckle\"/>"
         "<actuator name=\"hand_motor\"/></transmission>");
  request.prefix = "left_";
  const std::string all = bench.text(arm, attached(bench.reader(), arm, hand, request));
  expect(all,
         "<ros2_control name=\"left_sys\" type=\"system\"><joint name=\"left_knuckle\"/>"
         "<sensor name=\"left_ft\"/></ros2_control>");
  expect(all,
         "<transmission name=\"left_hand_t\"><joint name=\"left_knuckle\"/>"
         "<actuator name=\"left_motor\"/></transmission>");
}

TEST(Attach, MaterialsOfOneNameThatLookDifferent) {
  std::string green = kJaws;
  green.replace(green.find("0.5 0.5 0.5 1"), 13, "0 1 0 1");
  VerbBench bench({{"arm.urdf", kCarrierArm}, {"jaws.urdf", green}});
  const EditedModel& arm = bench.open("arm.urdf");
  AttachRequest request;
  request.link = "tool";
  const std::string text =
      bench.text(arm, attached(bench.reader(), arm, bench.open("jaws.urdf"), request));
  EXPECT_NE(text.find(R"(<material name="jaws_grey"><color rgba="0 1 0 1"/>)"), std::string::npos);
  EXPECT_NE(text.find(R"(<material name="jaws_grey"/></visual>)"), std::string::npos);
}

TEST(Attach, AnSdfModelIsNested) {
  constexpr const char* kBase = R"(<sdf version="1.9"><model name="arm">
  <link name="tool"><pose>0 0 1 0 0 0</pose></link>
</model></sdf>
)";
  constexpr const char* kHand = R"(<sdf version="1.9">
  <model name="hand">
    <pose>7 7 7 0 0 0</pose>
    <link name="palm"><pose>0 0 0.5 0 0 0</pose></link> <!-- palm -->
  </model>
</sdf>
)";
  VerbBench bench({{"arm.sdf", kBase}, {"hand.sdf", kHand}});
  const EditedModel& arm = bench.open("arm.sdf");
  AttachRequest request;
  request.link = "tool";
  request.X_LG = {{0.25, 0, 0}, {}};
  request.joint = AttachJoint::kRevolute;
  request.lower = -1, request.upper = 1, request.effort = 2, request.velocity = 3;
  const std::string text =
      bench.text(arm, attached(bench.reader(), arm, bench.open("hand.sdf"), request));
  const robot::Robot& whole = bench.open_text("arm.sdf", text).robot;
  ASSERT_EQ(whole.bodies.size(), 2U);
  EXPECT_EQ(whole.bodies[1].name, "hand::palm");
  const auto palm = whole.bodies[1].X_MB.translation;
  EXPECT_EQ(palm, (model::Vector3{0.25, 0, 1.5})) << text;
  EXPECT_NE(text.find("<!-- palm -->"), std::string::npos);
  EXPECT_EQ(text.find("7 7 7"), std::string::npos);
  ASSERT_EQ(whole.joints.size(), 1U);
  EXPECT_EQ(whole.joints[0].axes[0].direction, (model::Vector3{0, 0, 1}));
}

constexpr const char* kFramedArm = R"(<sdf version="1.9"><model name="arm">
  <link name="base"/>
  <joint name="j" type="fixed"><parent>base</parent><child>tool</child></joint>
  <link name="tool"><pose>0 0 1 0 0 0</pose></link>
  <frame name="flange" attached_to="tool"><pose>0 0 0.25 0 0 0</pose></frame>
</model></sdf>
)";
constexpr const char* kFramedHand = R"(<sdf version="1.8">
  <model name="hand">
    <link name="palm"><pose>0 0 0.5 0 0 0</pose></link>
    <frame name="mount"><pose>0.125 0 0 0 0 0</pose></frame>
  </model>
</sdf>
)";

TEST(Attach, AnSdfModelByInclude) {
  VerbBench bench({{"ws/arm/model.config",
                    "<model><name>arm</name><sdf version=\"1.9\">model.sdf</sdf></model>"},
                   {"ws/arm/model.sdf", kFramedArm},
                   {"ws/hand/model.config",
                    "<model><name>hand</name><sdf version=\"1.8\">model.sdf</sdf></model>"},
                   {"ws/hand/model.sdf", kFramedHand}});
  const EditedModel& arm = bench.open("ws/arm/model.sdf");
  AttachRequest request;
  request.frame = "flange";
  request.tool_frame = "mount";
  request.X_LG = {{0, 0, 0.5}, {}};
  request.by = AttachBy::kInclude;
  const std::string text =
      bench.text(arm, attached(bench.reader(), arm, bench.open("ws/hand/model.sdf"), request));
  const std::string source = kFramedArm;
  EXPECT_EQ(text, source.substr(0, source.find("</model>")) + R"(  <include>
    <uri>model://hand</uri>
    <name>hand</name>
    <pose relative_to="flange">0 0 0.5 0 0 0</pose>
    <placement_frame>mount</placement_frame>
  </include>
  <joint name="tool_to_hand" type="fixed">
    <parent>tool</parent>
    <child>hand::palm</child>
  </joint>
</model></sdf>
)");
  const EditedModel& whole = bench.open_text("ws/arm/model.sdf", text);
  // tool 1, flange 0.25, pose 0.5, palm 0.5 up; the mount is 0.125 before the hand's own frame.
  EXPECT_EQ(whole.robot.bodies[whole.body_index("hand::palm")].X_MB.translation,
            (model::Vector3{-0.125, 0, 2.25}));
  request.by = AttachBy::kCopy;
  EXPECT_EQ(attached(bench.reader(), arm, bench.open("ws/hand/model.sdf"), request).refused,
            "one is SDF 1.9 and one 1.8: bring them to one version first");
  request.frame = "nowhere";
  request.link = "tool";
  EXPECT_EQ(attached(bench.reader(), arm, bench.open("ws/hand/model.sdf"), request).refused,
            "no frame is named 'nowhere'");
}

TEST(Attach, FramesOfAUrdfAreItsLinks) {
  VerbBench bench({{"arm.urdf", kCarrierArm}, {"jaws.urdf", kJaws}});
  const EditedModel& arm = bench.open("arm.urdf");
  AttachRequest request;
  request.link = "tool";
  request.frame = "base";
  request.tool_frame = "finger";
  request.X_LG = {{0, 0, 2}, {}};
  const std::string text =
      bench.text(arm, attached(bench.reader(), arm, bench.open("jaws.urdf"), request));
  EXPECT_NE(text.find("<origin xyz=\"0 -0.1 1\" rpy=\"0 0 0\"/>"), std::string::npos) << text;
  const EditedModel& whole = bench.open_text("arm.urdf", text);
  EXPECT_EQ(whole.robot.bodies[whole.body_index("jaws_finger")].X_MB.translation,
            (model::Vector3{0, 0, 2}));
}

constexpr const char* kTemplateArm =
    R"(<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="height" value="1"/>
  <link name="base"/>
  <joint name="j" type="fixed">
    <origin xyz="0 0 ${height}"/><parent link="base"/><child link="tool"/>
  </joint>
  <link name="tool"/>
</robot>
)";

TEST(Attach, ATemplateIncludesARobot) {
  VerbBench bench({{"arm.urdf.xacro", kTemplateArm},
                   {"parts/lamp.urdf", "<robot name=\"lamp\"><link name=\"bulb\"/></robot>"},
                   {"parts/tool.urdf", "<robot name=\"lamp\"><link name=\"tool\"/></robot>"}});
  const EditedModel& arm = bench.open("arm.urdf.xacro");
  AttachRequest request;
  request.link = "tool";
  request.X_LG = {{0, 0, 0.5}, {}};
  const std::string text =
      bench.text(arm, attached(bench.reader(), arm, bench.open("parts/lamp.urdf"), request));
  const std::string source = kTemplateArm;
  EXPECT_EQ(text, source.substr(0, source.find("</robot>")) +
                      R"(  <xacro:include filename="parts/lamp.urdf"/>
  <joint name="tool_to_lamp" type="fixed">
    <origin xyz="0 0 0.5" rpy="0 0 0"/>
    <parent link="tool"/>
    <child link="bulb"/>
  </joint>
</robot>
)");
  EXPECT_EQ(attached(bench.reader(), arm, bench.open("parts/tool.urdf"), request).refused,
            "names of parts/tool.urdf are taken, and a file that is included keeps them");
}

constexpr const char* kGripperMacro =
    R"(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="gripper" params="prefix parent *origin stroke:=0.1 color">
    <link name="${prefix}palm"/>
    <joint name="${prefix}mount" type="fixed">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/><child link="${prefix}palm"/>
    </joint>
  </xacro:macro>
</robot>
)";

TEST(Attach, ATemplateCallsAMacro) {
  VerbBench bench({{"urdf/arm.urdf.xacro", kTemplateArm}, {"urdf/gripper.xacro", kGripperMacro}});
  const EditedModel& arm = bench.open("urdf/arm.urdf.xacro");
  MacroRequest request;
  request.attach.link = "tool";
  request.attach.prefix = "left_";
  request.attach.X_LG = {{0, 0, 0.5}, {}};
  const auto call = [&] {
    return attached_by_macro(bench.reader(), arm, "urdf/gripper.xacro", request);
  };
  EXPECT_EQ(call().refused, "macro 'gripper' needs color: give each as --param NAME=VALUE");
  request.parameters["color"] = "red";
  const std::string text = bench.text(arm, call());
  const std::string source = kTemplateArm;
  EXPECT_EQ(text, source.substr(0, source.find("</robot>")) +
                      R"(  <xacro:include filename="gripper.xacro"/>
  <xacro:gripper prefix="left_" parent="tool" color="red">
    <origin xyz="0 0 0.5" rpy="0 0 0"/>
  </xacro:gripper>
</robot>
)");
  const EditedModel& whole = bench.open_text("urdf/arm.urdf.xacro", text);
  EXPECT_EQ(whole.robot.bodies[whole.body_index("left_palm")].X_MB.translation,
            (model::Vector3{0, 0, 1.5}));
  request.parameters["colour"] = "red";
  EXPECT_EQ(call().refused, "macro 'gripper' has no parameter 'colour'");
  request.macro = "hand";
  EXPECT_EQ(call().refused, "urdf/gripper.xacro defines no such macro");
}

TEST(Attach, AMacroWithoutAParentGetsAJoint) {
  VerbBench bench({{"arm.urdf.xacro", kTemplateArm},
                   {"lamp.xacro", R"(<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="lamp" params="prefix"><link name="${prefix}bulb"/></xacro:macro>
</robot>)"}});
  const EditedModel& arm = bench.open("arm.urdf.xacro");
  MacroRequest request;
  request.attach.link = "tool";
  request.attach.X_LG = {{0, 0, 0.5}, {}};
  const std::string text =
      bench.text(arm, attached_by_macro(bench.reader(), arm, "lamp.xacro", request));
  const EditedModel& whole = bench.open_text("arm.urdf.xacro", text);
  EXPECT_EQ(whole.robot.bodies[whole.body_index("bulb")].X_MB.translation,
            (model::Vector3{0, 0, 1.5}))
      << text;
}

TEST(Attach, WhatItRefuses) {
  VerbBench bench(
      {{"arm.urdf", kCarrierArm},
       {"m.sdf", R"(<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>)"},
       {"w.urdf", R"(<robot name="w"><link name="world"/><link name="a"/>
<joint name="j" type="fixed"><parent link="world"/><child link="a"/></joint></robot>)"}});
  const EditedModel& arm = bench.open("arm.urdf");
  AttachRequest request;
  request.link = "tool";
  const auto why = [&](const char* path) {
    return attached(bench.reader(), arm, bench.open(path), request).refused;
  };
  EXPECT_EQ(why("m.sdf"), "one is SDF and one URDF: convert one of them first");
  EXPECT_EQ(why("w.urdf"), "w.urdf is fixed to the world: extract its base link first");
  request.link = "flange";
  EXPECT_EQ(why("arm.urdf"), "no link is named 'flange'");
}

}  // namespace
}  // namespace rigor::author
