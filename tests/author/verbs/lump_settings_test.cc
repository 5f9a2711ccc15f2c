// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// lump: what links say of themselves, which parts cannot, and what goes on naming them.

#include <gtest/gtest.h>

#include <rigor/author/verbs/lump/lump.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

/// Links a and b on a fixed joint.
std::string pair_sdf(const std::string& in_a, const std::string& in_b,
                     const std::string& in_joint = {}, const std::string& in_model = {}) {
  return "<sdf version=\"1.9\"><model name=\"m\">\n  <link name=\"a\">" + in_a +
         "</link>\n  <link name=\"b\">" + in_b +
         "</link>\n  <joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child>" +
         in_joint + "</joint>\n" + in_model + "</model></sdf>\n";
}

std::string refused_sdf(const std::string& text) {
  VerbBench bench({{"m.sdf", text}});
  return lumped(bench.open("m.sdf"), {}).refused;
}

TEST(LumpSettings, OfAnSdfLinkAreOfAllOfIt) {
  EXPECT_EQ(refused_sdf(pair_sdf("", "<gravity>false</gravity>")),
            "<gravity> of link 'b' is false, of link 'a' true: as one they would share it");
  EXPECT_EQ(refused_sdf(pair_sdf("<kinematic>1</kinematic>", "")),
            "<kinematic> of link 'b' is false, of link 'a' true: as one they would share it");
  EXPECT_EQ(
      refused_sdf(pair_sdf("", "<velocity_decay><linear>0.5</linear></velocity_decay>")),
      "<velocity_decay/linear> of link 'b' is 0.5, of link 'a' 0: as one they would share it");
  EXPECT_EQ(refused_sdf(pair_sdf("<gravity>0</gravity>", "<gravity>false</gravity>")), "");
  EXPECT_EQ(refused_sdf(pair_sdf("", "<self_collide>false</self_collide>")), "");
  // A link has it of its model.
  EXPECT_EQ(refused_sdf(pair_sdf("", "<enable_wind>true</enable_wind>", "",
                                 "  <enable_wind>true</enable_wind>\n")),
            "");
  EXPECT_EQ(refused_sdf(pair_sdf("", "<enable_wind>true</enable_wind>")),
            "<enable_wind> of link 'b' is true, of link 'a' false: as one they would share it");
}

TEST(LumpSettings, WhatWouldBeLostIsRefused) {
  EXPECT_EQ(refused_sdf(pair_sdf("", "", "<sensor name=\"ft\" type=\"force_torque\"/>")),
            "line 4: sensor 'ft' is on joint 'j', which would go");
  EXPECT_EQ(refused_sdf(pair_sdf("", "<my:magnet/>")),
            "line 3: <my:magnet> of link 'b' would be lost");
  EXPECT_EQ(refused_sdf(pair_sdf("", "", "",
                                 "<gripper name=\"g\"><gripper_link>b</gripper_link>"
                                 "<palm_link>a</palm_link></gripper>\n")),
            "line 5: a gripper names it");
}

TEST(LumpSettings, ANameThatIsTakenIsRenamedWhereASensorNamesIt) {
  constexpr const char* kBox =
      R"(<collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>)";
  const std::string contact =
      R"(<sensor name="s" type="contact"><contact><collision>c</collision></contact></sensor>)";
  VerbBench bench({{"m.sdf", pair_sdf(kBox, kBox + contact)}});
  const EditedModel& m = bench.open("m.sdf");
  const std::string text = bench.text(m, lumped(m, {}));
  EXPECT_NE(text.find("<collision>b_c</collision>"), std::string::npos) << text;
}

TEST(LumpSettings, NamesThatAreLeft) {
  VerbBench bench({{"m.sdf", pair_sdf("", "", "",
                                      "  <frame name=\"f\" attached_to=\"b\"/>\n"
                                      "  <plugin name=\"p\" filename=\"p.so\">"
                                      "<link_name>b</link_name><joint_name>j</joint_name>"
                                      "</plugin>\n")},
                   {"c.sdf", R"(<sdf version="1.9"><model name="m" canonical_link="b">
  <link name="a"/><link name="b"/>
  <joint name="j" type="fixed"><parent>a</parent><child>b</child></joint>
</model></sdf>
)"}});
  const Change change = lumped(bench.open("m.sdf"), {});
  EXPECT_EQ(change.refused, "");
  EXPECT_EQ(change.notes,
            (std::vector<std::string>{"link b is part of a now",
                                      "m.sdf:6: a plugin names link b, which is part of a now",
                                      "m.sdf:6: a plugin names joint j, which is gone"}));
  const EditedModel& c = bench.open("c.sdf");
  EXPECT_NE(bench.text(c, lumped(c, {})).find("canonical_link=\"a\""), std::string::npos);
}

constexpr const char* kShapes =
    R"(<visual><geometry><box size="1 1 1"/></geometry></visual><collision><geometry><box size="1 1 1"/></geometry></collision>)";

std::string pair_urdf(const std::string& in_a, const std::string& in_b, const std::string& blocks) {
  return "<robot name=\"r\">\n  <link name=\"a\">" + in_a + "</link>\n  <link name=\"b\">" + in_b +
         "</link>\n  <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child "
         "link=\"b\"/></joint>\n" +
         blocks + "</robot>\n";
}

/// The text, or why there is none.
std::string lumped_urdf(const std::string& text) {
  VerbBench bench({{"r.urdf", text}});
  const EditedModel& robot = bench.open("r.urdf");
  const Change change = lumped(robot, {});
  return change.refused.empty() ? bench.text(robot, change) : change.refused;
}

TEST(LumpSettings, OfAUrdfLinkAreOfAllOfIt) {
  EXPECT_EQ(
      lumped_urdf(pair_urdf(kShapes, kShapes, "<gazebo reference=\"b\"><mu1>0.5</mu1></gazebo>\n")),
      "<mu1> in <gazebo> is 0.5 for link 'b' and not given for link 'a': as one they would "
      "share it");
  EXPECT_EQ(
      lumped_urdf(pair_urdf(kShapes, kShapes, "<gazebo reference=\"a\"><kp>5000</kp></gazebo>\n")),
      "<kp> in <gazebo> is not given for link 'b' and 5000 for link 'a': as one they would "
      "share it");
  EXPECT_EQ(
      lumped_urdf(pair_urdf("", "", "<gazebo reference=\"b\"><gravity>0</gravity></gazebo>\n")),
      "<gravity> in <gazebo> is 0 for link 'b' and not given for link 'a': as one they would "
      "share it");
  EXPECT_EQ(
      lumped_urdf(pair_urdf(kShapes, kShapes,
                            "<gazebo reference=\"b\"><material>Gazebo/Red</material></gazebo>\n")),
      "<material> in <gazebo> is Gazebo/Red for link 'b' and not given for link 'a': as one "
      "they would share it");
}

TEST(LumpSettings, OfAUrdfLinkThatMeanTheSame) {
  // Both say so: once is enough.
  const std::string same = lumped_urdf(pair_urdf(
      kShapes, kShapes,
      "<gazebo reference=\"a\"><mu1>0.50</mu1></gazebo>\n"
      "<gazebo reference=\"b\"><mu1 value=\"0.5\"/><sensor name=\"s\" type=\"imu\"/></gazebo>\n"));
  EXPECT_NE(same.find("<gazebo reference=\"a\"><mu1>0.50</mu1></gazebo>\n"
                      "<gazebo reference=\"a\"><sensor name=\"s\" type=\"imu\"/></gazebo>\n"),
            std::string::npos)
      << same;
  // Only b has shapes.
  const std::string only =
      lumped_urdf(pair_urdf("", kShapes, "<gazebo reference=\"b\"><mu1>0.5</mu1></gazebo>\n"));
  EXPECT_NE(only.find("<gazebo reference=\"a\"><mu1>0.5</mu1></gazebo>\n"), std::string::npos)
      << only;
  // Only a has: what b says is of nothing, and would be of a's.
  const std::string none =
      lumped_urdf(pair_urdf(kShapes, "", "<gazebo reference=\"b\"><mu1>0.5</mu1></gazebo>\n"));
  EXPECT_EQ(none.find("<mu1>"), std::string::npos) << none;
  const std::string gravity =
      lumped_urdf(pair_urdf("", "", "<gazebo reference=\"b\"><gravity>true</gravity></gazebo>\n"));
  EXPECT_NE(gravity.find("<gazebo reference=\"a\">"), std::string::npos) << gravity;
}

TEST(LumpSettings, WhatAUrdfsJointHasIsRefused) {
  EXPECT_EQ(lumped_urdf(pair_urdf("", "",
                                  "<gazebo reference=\"j\"><sensor name=\"ft\" "
                                  "type=\"force_torque\"/></gazebo>\n")),
            "line 5: sensor 'ft' is on joint 'j', which would go");
}

TEST(LumpSettings, NamesThatAreLeftInAUrdf) {
  VerbBench bench(
      {{"r.urdf", pair_urdf("", "",
                            "<sensor name=\"s\"><parent joint=\"j\"/></sensor>\n"
                            "<gazebo><plugin name=\"p\" filename=\"p.so\">"
                            "<bodyName>b</bodyName></plugin></gazebo>\n"
                            "<transmission name=\"t\"><joint name=\"j\"/></transmission>\n")}});
  const EditedModel& robot = bench.open("r.urdf");
  const Change change = lumped(robot, {});
  EXPECT_NE(bench.text(robot, change).find("<sensor name=\"s\"><parent link=\"a\"/></sensor>"),
            std::string::npos);
  EXPECT_EQ(change.notes,
            (std::vector<std::string>{"link b is part of a now",
                                      "r.urdf:6: a plugin names link b, which is part of a now",
                                      "r.urdf:7: <joint> names joint j, which is gone"}));
}

}  // namespace
}  // namespace rigor::author
