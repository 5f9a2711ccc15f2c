// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <rigor/convert/xml_layout.h>

#include "convert/urdf_part.h"

namespace rigor::convert {
namespace {

using test::of_kind;
using test::UrdfPart;

/// A collision of a sphere with this inside.
std::string sphere_collision(const std::string& name, const std::string& inside) {
  return "<collision name='" + name + "'><geometry><sphere><radius>1</radius></sphere></geometry>" +
         inside + "</collision>";
}

std::string ode_friction(const std::string& values) {
  return "<surface><friction><ode>" + values + "</ode></friction></surface>";
}

TEST(UrdfBlock, CarriesWhatAllCollisionsAgreeIn) {
  UrdfPart part(
      "<link name='base'>" +
      sphere_collision("a", "<max_contacts>4</max_contacts>" +
                                ode_friction("<mu>0.50</mu><mu2>1</mu2><fdir1>0 0 1</fdir1>")) +
      sphere_collision("b", "<max_contacts>4</max_contacts>" +
                                ode_friction("<mu>.5</mu><fdir1>0 0 1.0</fdir1>")) +
      "</link>");
  ASSERT_EQ(part.draft.robot.blocks.size(), 1U);
  EXPECT_EQ(part.draft.robot.blocks[0].reference, "base");
  // A friction of 1 is the default, written or not.
  EXPECT_EQ(part.draft.robot.blocks[0].xml,
            "<mu1>0.50</mu1>\n<fdir1>0 0 1</fdir1>\n<maxContacts>4</maxContacts>\n");
  EXPECT_TRUE(of_kind(part.account().notes, NoteKind::kSurface).empty());
}

TEST(UrdfBlock, CarriesContactParameters) {
  const UrdfPart part("<link name='base'>" +
                      sphere_collision("a",
                                       "<surface><contact><ode><kp>1e5</kp><kd>10</kd><max_vel>0.1"
                                       "</max_vel><min_depth>0.001</min_depth></ode></contact>"
                                       "</surface>") +
                      "</link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml,
            "<kp>1e5</kp>\n<kd>10</kd>\n<maxVel>0.1</maxVel>\n<minDepth>0.001</minDepth>\n");
}

/// What `ign sdf -p` (libsdformat 12) turns back into the same elements.
TEST(UrdfBlock, CarriesReflectionAndDamping) {
  const std::string retro = "<laser_retro>7</laser_retro>";
  UrdfPart part(
      "<link name='base'><velocity_decay><linear>0.10</linear><angular>.1</angular>"
      "</velocity_decay>" +
      sphere_collision("a", retro) + sphere_collision("b", retro) + "</link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml,
            "<laserRetro>7</laserRetro>\n<dampingFactor>0.10</dampingFactor>\n");
  const Account account = part.account();
  EXPECT_EQ(of_kind(account.notes, NoteKind::kLinkPhysics).at(0).outcome, Outcome::kCarried);
  EXPECT_TRUE(of_kind(account.notes, NoteKind::kVisualExtra).empty());

  const UrdfPart differ(
      "<link name='base'><velocity_decay><linear>0.1</linear><angular>0.2</angular>"
      "</velocity_decay></link>");
  EXPECT_EQ(differ.draft.robot.blocks.at(0).xml,
            "<velocity_decay>\n  <linear>0.1</linear>\n  <angular>0.2</angular>\n"
            "</velocity_decay>\n");
  EXPECT_TRUE(UrdfPart("<link name='base'><velocity_decay/></link>").draft.robot.blocks.empty());
}

TEST(UrdfBlock, LosesWhatCollisionsDifferIn) {
  UrdfPart part("<link name='base'>" + sphere_collision("a", ode_friction("<mu>0.5</mu>")) +
                sphere_collision("b", ode_friction("<mu>0.7</mu>")) + sphere_collision("c", "") +
                "</link>");
  EXPECT_TRUE(part.draft.robot.blocks.empty());
  const auto notes = of_kind(part.account().notes, NoteKind::kSurface);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].outcome, Outcome::kLost);
  EXPECT_EQ(notes[0].written, "mu1 0.5, 0.7, default");
  EXPECT_EQ(notes[0].count, 2U);
}

TEST(UrdfBlock, ACollisionThatIsLostHasNoSay) {
  const UrdfPart part("<link name='base'>" + sphere_collision("a", ode_friction("<mu>0.5</mu>")) +
                      "<collision name='p'><geometry><plane/></geometry></collision></link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml, "<mu1>0.5</mu1>\n");
}

TEST(UrdfBlock, PartsThatItSpeaksOfBeginWithTheLinksName) {
  UrdfPart part("<link name='base'>" + sphere_collision("a", ode_friction("<mu>0.5</mu>")) +
                sphere_collision("base_b", ode_friction("<mu>0.5</mu>")) + "</link>");
  EXPECT_EQ(part.link.collisions.at(0).name, "base_a");
  EXPECT_EQ(part.link.collisions.at(1).name, "base_b");
  const auto notes = of_kind(part.account().notes, NoteKind::kRenamed);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].instead, "base_a");

  const UrdfPart plain("<link name='base'>" + sphere_collision("a", "") + "</link>");
  EXPECT_EQ(plain.link.collisions.at(0).name, "a");
}

TEST(UrdfBlock, OtherSurfaceParametersAreLost) {
  UrdfPart part("<link name='base'>" +
                sphere_collision("a",
                                 "<surface><bounce><restitution_coefficient>0.9"
                                 "</restitution_coefficient></bounce></surface>") +
                "</link>");
  const auto notes = of_kind(part.account().notes, NoteKind::kSurface);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].outcome, Outcome::kLost);
}

TEST(UrdfBlock, SelfCollisionAndGravity) {
  UrdfPart part("<self_collide>1</self_collide><link name='base'><gravity>false</gravity></link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml,
            "<selfCollide>true</selfCollide>\n<turnGravityOff>true</turnGravityOff>\n");
  const Account account = part.account();
  EXPECT_EQ(of_kind(account.notes, NoteKind::kGravity).at(0).outcome, Outcome::kCarried);
  EXPECT_EQ(of_kind(account.notes, NoteKind::kSelfCollide).at(0).outcome, Outcome::kCarried);

  const UrdfPart other(
      "<self_collide>true</self_collide><link "
      "name='base'><self_collide>false</self_collide></link>");
  EXPECT_TRUE(other.draft.robot.blocks.empty());
}

TEST(UrdfBlock, CarriesSensorsAndPluginsAsTheyAre) {
  UrdfPart part(
      "<link name='base'><sensor name='eye' type='camera'><pose>1.0 0 0 0 0 0</pose>\n"
      "      <camera\n         name='c'><image/></camera>\n<!-- noise -->\n"
      "<topic>a\n b</topic></sensor><light name='lamp' type='point'/></link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml,
            "<sensor name='eye' type='camera'>\n  <pose>1.0 0 0 0 0 0</pose>\n"
            "  <camera name='c'>\n    <image/>\n  </camera>\n  <!-- noise -->\n"
            "  <topic>a\n b</topic>\n</sensor>\n<light name='lamp' type='point'/>\n");
  const Account account = part.account();
  EXPECT_EQ(of_kind(account.notes, NoteKind::kSensor).at(0).outcome, Outcome::kCarried);
  EXPECT_EQ(of_kind(account.notes, NoteKind::kSensor).at(0).count, 8U);  // 5 elements, 3 attributes
  EXPECT_EQ(of_kind(account.notes, NoteKind::kLight).at(0).written, "lamp");
}

TEST(UrdfBlock, ASensorsPoseLeavesOtherFrames) {
  const UrdfPart part(
      "<frame name='f'><pose>0 0 2 0 0 0</pose></frame><link name='base'><sensor name='s' "
      "type='imu'><pose relative_to='f'>1 0 0 0 0 0</pose></sensor></link>");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml,
            "<sensor name='s' type='imu'>\n  <pose>1 0 2 0 0 0</pose>\n</sensor>\n");
}

TEST(UrdfBlock, KeepsNamespacesThatAreDeclaredOutside) {
  const std::string text = "<a xmlns:gz='G' xmlns:x='X'><b gz:t='1'><x:c/></b><d/></a>";
  const xml::Document document = xml::parse(text, kNoSource);
  EXPECT_EQ(laid_out(document, document.element(1)),
            "<b xmlns:gz='G' xmlns:x='X' gz:t='1'>\n  <x:c/>\n</b>\n");
  EXPECT_EQ(laid_out(document, document.element(3)), "<d/>\n");
  EXPECT_EQ(laid_out(document, document.element(3), {.pose = "<pose>1</pose>"}),
            "<d>\n  <pose>1</pose>\n</d>\n");
}

TEST(UrdfBlock, OfAModel) {
  UrdfPart part(
      "<static>true</static><plugin name='p' filename='lib.so'><x>1</x></plugin>"
      "<model name='inner'><static>true</static></model>");
  add_model_blocks(part.draft, {0});
  add_model_blocks(part.draft, {1});
  ASSERT_EQ(part.draft.robot.blocks.size(), 1U);
  EXPECT_EQ(part.draft.robot.blocks[0].reference, "");
  EXPECT_EQ(part.draft.robot.blocks[0].xml,
            "<static>true</static>\n<plugin name='p' filename='lib.so'>\n  <x>1</x>\n</plugin>\n");
  const auto notes = of_kind(part.account().notes, NoteKind::kStatic);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].outcome, Outcome::kCarried);
  EXPECT_EQ(notes[1].outcome, Outcome::kLost);  // a part of a robot that the block cannot name
}

TEST(UrdfBlock, OfAJoint) {
  UrdfPart part(
      "<link name='a'/><link name='b'/><joint name='j' type='revolute'><parent>a</parent><child>b"
      "</child><axis><xyz>0 0 1</xyz><dynamics><spring_reference>0.10</spring_reference>"
      "<spring_stiffness>5.0</spring_stiffness></dynamics></axis><physics><ode>"
      "<implicit_spring_damper>1</implicit_spring_damper><limit><cfm>0.1</cfm><erp>0.2</erp></"
      "limit>"
      "<max_force>7</max_force></ode><provide_feedback>true</provide_feedback></physics>"
      "<sensor name='ft' type='force_torque'/></joint>");
  add_joint_blocks(part.draft, {0}, "j_1");
  ASSERT_EQ(part.draft.robot.blocks.size(), 1U);
  EXPECT_EQ(part.draft.robot.blocks[0].reference, "j_1");
  // An erp of 0.2 is the default.
  EXPECT_EQ(part.draft.robot.blocks[0].xml,
            "<provideFeedback>true</provideFeedback>\n<implicitSpringDamper>1"
            "</implicitSpringDamper>\n<stopCfm>0.1</stopCfm>\n<springReference>0.10"
            "</springReference>\n<springStiffness>5.0</springStiffness>\n"
            "<sensor name='ft' type='force_torque'/>\n");
  const Account account = part.account();
  EXPECT_EQ(of_kind(account.notes, NoteKind::kSpring).at(0).outcome, Outcome::kCarried);
  const auto lost = of_kind(account.notes, NoteKind::kPhysics);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].written, "joint/physics/ode/max_force");
}

TEST(UrdfBlock, AFixedJointStays) {
  UrdfPart part(
      "<link name='a'/><link name='b'/><joint name='j' type='fixed'><parent>a</parent><child>b"
      "</child></joint>");
  add_joint_blocks(part.draft, {0}, "j");
  EXPECT_EQ(part.draft.robot.blocks.at(0).xml, "<preserveFixedJoint>true</preserveFixedJoint>\n");
}

}  // namespace
}  // namespace rigor::convert
