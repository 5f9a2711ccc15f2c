// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <rigor/convert/urdf_to_sdf.h>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

/// Two links with a joint between, a massless tip, and what `blocks` says of them.
std::string robot_with_blocks(const std::string& blocks) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
      "izz='1'/></inertial>";
  const std::string ball = "<geometry><sphere radius='1'/></geometry>";
  return "<robot name='r'><link name='a'>" + inertial + "<visual name='v'>" + ball +
         "</visual><collision name='c'>" + ball + "</collision><collision name='d'>" + ball +
         "</collision></link><link name='b'>" + inertial +
         "</link><link name='tip'/><joint name='j' type='continuous'><parent link='a'/><child "
         "link='b'/></joint>"
         "<joint name='k' type='fixed'><parent link='b'/><child link='tip'/><origin xyz='0 0 "
         "1'/></joint>" +
         blocks + "</robot>";
}

struct ConvertedBlocks {
  std::string text;  ///< of the SDF, without white space between its tags
  Account account;

  explicit ConvertedBlocks(const std::string& blocks) {
    const test::LoadedRobot robot(robot_with_blocks(blocks));
    SdfConversion result = urdf_to_sdf(robot.source(), {});
    account = std::move(result.account);
    bool space = true;
    for (const char c : sdf_text(*result.robot)) {
      space = c == '\n' || (space && c == ' ');
      if (!space) text += c;
    }
  }
  int count(const std::string& part) const {
    int n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++n;
    return n;
  }
  std::vector<NoteKind> losses() const {
    std::vector<NoteKind> kinds;
    for (const Note& note : account.notes) {
      if (note.outcome == Outcome::kLost) kinds.push_back(note.kind);
    }
    return kinds;
  }
};

TEST(SdfGazebo, SurfaceKeysGoToEachCollisionOfTheLink) {
  const ConvertedBlocks blocks(
      "<gazebo reference='a'><mu1>0.80</mu1><mu2>0.9</mu2><fdir1>1 0 "
      "0</fdir1><kp>1e6</kp><kd>10</kd>"
      "<maxVel>0.1</maxVel><minDepth>0.001</minDepth><maxContacts>4</maxContacts></gazebo>");
  EXPECT_EQ(
      blocks.count(
          "<surface><friction><ode><mu>0.80</mu><mu2>0.9</mu2><fdir1>1 0 0</fdir1></ode>"
          "</friction><contact><ode><kp>1e6</kp><kd>10</kd><max_vel>0.1</max_vel>"
          "<min_depth>0.001</min_depth></ode></contact></surface><max_contacts>4</max_contacts>"),
      2);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, FrictionWithoutCollisionIsToldOnce) {
  const ConvertedBlocks blocks("<gazebo reference='b'><mu1>1</mu1><kp>2</kp></gazebo>");
  EXPECT_EQ(blocks.losses(), std::vector{NoteKind::kBlockWithoutCollision});
  EXPECT_EQ(blocks.account.notes.back().written, "mu1, kp");
}

TEST(SdfGazebo, LinkKeysAreSettingsOfTheLink) {
  const ConvertedBlocks blocks(
      "<gazebo reference='b'><selfCollide>true</selfCollide><turnGravityOff>true</turnGravityOff>"
      "<dampingFactor>0.01</dampingFactor></gazebo>");
  EXPECT_EQ(blocks.count("<self_collide>true</self_collide><gravity>false</gravity><velocity_decay>"
                         "<linear>0.01</linear><angular>0.01</angular></velocity_decay>"),
            1);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, AMaterialIsAScriptOfTheVisuals) {
  const ConvertedBlocks blocks("<gazebo reference='a'><material>Gazebo/Blue</material></gazebo>");
  EXPECT_EQ(blocks.count("<name>Gazebo/Blue</name>"), 1);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, RawShapesAreMergedIntoTheLinksOwn) {
  const ConvertedBlocks blocks(
      "<gazebo reference='a'><visual><material><diffuse>1 0 0 1</diffuse></material></visual>"
      "<collision><surface><bounce><threshold>2</threshold></bounce></surface></collision></"
      "gazebo>");
  EXPECT_EQ(blocks.count("<material><diffuse>1 0 0 1</diffuse></material></visual>"), 1);
  EXPECT_EQ(
      blocks.count("<surface><bounce><threshold>2</threshold></bounce></surface></collision>"), 2);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, JointKeysGoToTheJoint) {
  const ConvertedBlocks blocks(
      "<gazebo "
      "reference='j'><stopCfm>0.1</stopCfm><stopErp>0.2</stopErp><provideFeedback>true</"
      "provideFeedback>"
      "<implicitSpringDamper>1</implicitSpringDamper><springStiffness>5</springStiffness>"
      "<springReference>0.5</springReference></gazebo>");
  EXPECT_EQ(blocks.count("<physics><ode><limit><cfm>0.1</cfm><erp>0.2</erp></limit>"
                         "<implicit_spring_damper>1</implicit_spring_damper></ode>"
                         "<provide_feedback>true</provide_feedback></physics>"),
            1);
  EXPECT_EQ(blocks.count("<dynamics><spring_stiffness>5</spring_stiffness>"
                         "<spring_reference>0.5</spring_reference></dynamics>"),
            1);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, ASensorOfALinkThatBecameAFrameStandsWhereItStood) {
  const ConvertedBlocks blocks(
      "<gazebo reference='tip'><sensor name='s' type='imu'><pose>1 0 0 0 0 "
      "0</pose></sensor></gazebo>"
      "<gazebo reference='tip'><sensor name='t' type='imu'/></gazebo>");
  EXPECT_EQ(blocks.count("<frame name=\"k\" attached_to=\"b\">"), 1);
  EXPECT_EQ(blocks.count("<frame name=\"tip\" attached_to=\"k\"/>"), 1);
  EXPECT_EQ(blocks.count("<pose relative_to=\"tip\">1 0 0 0 0 0</pose>"), 1);
  EXPECT_EQ(blocks.count("<pose relative_to=\"tip\"/>"), 1);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, AJointThatIsMeasuredStaysAJoint) {
  const ConvertedBlocks blocks(
      "<gazebo reference='k'><sensor name='s' type='force_torque'/></gazebo>");
  EXPECT_EQ(blocks.count("<joint name=\"k\" type=\"fixed\">"), 1);
  EXPECT_EQ(blocks.count("type='force_torque'"), 1);
}

TEST(SdfGazebo, WhatIsOfTheRobotIsOfTheModel) {
  const ConvertedBlocks blocks(
      "<gazebo><static>true</static><plugin name='p' filename='f'><x> 1 </x></plugin></gazebo>");
  EXPECT_EQ(blocks.count("<model name=\"r\"><static>true</static>"), 1);
  EXPECT_EQ(blocks.count("<plugin name='p' filename='f'><x> 1 </x></plugin></model>"), 1);
  EXPECT_TRUE(blocks.losses().empty());
}

TEST(SdfGazebo, AnUnknownReferenceIsALoss) {
  const ConvertedBlocks blocks("<gazebo reference='ghost'><mu1>1</mu1></gazebo>");
  EXPECT_EQ(blocks.losses(), std::vector{NoteKind::kBlockReference});
  EXPECT_EQ(blocks.account.notes.back().count, 3U);  // the block, its reference, mu1
}

TEST(SdfGazebo, HintsForTheOfficialConverterAreNoLoss) {
  const ConvertedBlocks blocks(
      "<gazebo reference='k'><preserveFixedJoint>true</preserveFixedJoint>"
      "<disableFixedJointLumping>true</disableFixedJointLumping></gazebo>");
  EXPECT_TRUE(blocks.losses().empty());
  EXPECT_EQ(blocks.count("preserveFixedJoint"), 0);
}

/// libsdformat's GetKeyValueAsString: the attribute goes before the text.
TEST(SdfGazebo, ValuesAreAttributesToo) {
  const ConvertedBlocks converted(
      "<gazebo reference='a'><mu1 value='0.2'/><mu2 value='0.3'>9</mu2><kp value='1e6'/>"
      "<fdir1 value='1 0 0'/><selfCollide value='true'/><turnGravityOff value='true'/>"
      "<material value='Gazebo/Orange'/></gazebo><gazebo reference='j'>"
      "<springStiffness value='5'/></gazebo><gazebo><static value='true'/></gazebo>");
  EXPECT_EQ(converted.count("<mu>0.2</mu>"), 2) << converted.text;
  EXPECT_EQ(converted.count("<mu2>0.3</mu2>"), 2);
  EXPECT_EQ(converted.count("<kp>1e6</kp>"), 2);
  EXPECT_EQ(converted.count("<fdir1>1 0 0</fdir1>"), 2);
  EXPECT_EQ(converted.count("<self_collide>true</self_collide>"), 1);
  EXPECT_EQ(converted.count("<gravity>false</gravity>"), 1);
  EXPECT_EQ(converted.count("<name>Gazebo/Orange</name>"), 1);
  EXPECT_EQ(converted.count("<spring_stiffness>5</spring_stiffness>"), 1);
  EXPECT_EQ(converted.count("<static>true</static>"), 1);
  EXPECT_EQ(converted.losses(), std::vector<NoteKind>{});
}

TEST(SdfGazebo, AKeyWithoutAValueIsLost) {
  const ConvertedBlocks converted("<gazebo reference='a'><mu1/><kp> </kp></gazebo>");
  EXPECT_EQ(converted.count("<surface>"), 0) << converted.text;
  EXPECT_EQ(converted.losses().size(), 2U);
}

/// Gazebo Sim reads no scripts; the color is that of Gazebo's own gazebo.material.
TEST(SdfGazebo, AScriptHasItsColorBesideIt) {
  const ConvertedBlocks converted("<gazebo reference='a'><material>Gazebo/Red</material></gazebo>");
  EXPECT_EQ(converted.count("<ambient>1 0 0 1</ambient>"), 1) << converted.text;
  EXPECT_EQ(converted.count("<diffuse>1 0 0 1</diffuse>"), 1) << converted.text;
}

TEST(SdfGazebo, PluginsNameTheLinkThatHoldsAFrame) {
  const ConvertedBlocks converted(
      "<gazebo><plugin name='p3d' filename='libgazebo_ros_p3d.so'><bodyName>tip</bodyName>"
      "<xyzOffset>0.5 0 0</xyzOffset></plugin>"
      "<plugin name='wing' filename='gz-sim-lift-drag-system'><link_name>tip</link_name>"
      "<cp>0.1 0 0</cp><forward>1 0 0</forward><upward>0 0 1</upward></plugin></gazebo>");
  // `tip` is 1 m above b, in b's axes.
  EXPECT_EQ(converted.count("<bodyName>b</bodyName>"), 1) << converted.text;
  EXPECT_EQ(converted.count("<xyzOffset>0.5 0 1</xyzOffset>"), 1) << converted.text;
  EXPECT_EQ(converted.count("<link_name>b</link_name>"), 1);
  EXPECT_EQ(converted.count("<cp>0.1 0 1</cp>"), 1) << converted.text;
  EXPECT_EQ(converted.count("<forward>1 0 0</forward>"), 1);
}

/// libsdformat 12 rejects a `::` in the name of what is in no plugin.
TEST(SdfGazebo, NamesHaveNoScopes) {
  const ConvertedBlocks converted(
      "<gazebo reference='a'><sensor name='a::imu' type='imu'/></gazebo>"
      "<gazebo><api name='x::y'/><plugin name='p::q' filename='f'><api name='x::y'/></plugin>"
      "</gazebo>");
  EXPECT_EQ(converted.count("<sensor name='a__imu'"), 1) << converted.text;
  EXPECT_EQ(converted.count("<api name='x__y'/>"), 1) << converted.text;
  EXPECT_EQ(converted.count("<api name='x::y'/>"), 1) << "a plugin's own";
  EXPECT_EQ(converted.count("name='p::q'"), 1);
}

}  // namespace
}  // namespace rigor::convert
