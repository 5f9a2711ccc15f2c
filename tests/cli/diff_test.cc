// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor diff` as its users script it.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>
#include <robot/robots.h>

namespace rigor::test {
namespace {

using nlohmann::json;

/// The number of the line that `words` stand in.
std::string line_of(const std::string& text, const std::string& words) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(words));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

class DiffCli : public testing::Test {
 protected:
  DiffCli() {
    folder_.put("a.urdf", kArmUrdf);
    folder_.put("a.sdf", kArmSdf);
  }

  Ran diff(const std::string& arguments) const { return folder_.rigor("diff " + arguments); }
  Ran diff_with(const std::string& from, const std::string& to) const {
    folder_.put("b.urdf", with(kArmUrdf, from, to));
    return diff("a.urdf b.urdf");
  }

  Folder folder_;
};

TEST_F(DiffCli, TheSameIsSilent) {
  for (const char* pair : {"a.urdf a.urdf", "a.sdf a.sdf", "a.urdf a.sdf", "a.sdf a.urdf"}) {
    const Ran ran = diff(pair);
    EXPECT_EQ(ran.exit, 0) << pair;
    EXPECT_EQ(ran.out + ran.err, "") << pair;
  }
}

TEST_F(DiffCli, EachDifferenceIsALineWithItsPlace) {
  const Ran moved = diff_with("xyz=\"0 0 0.5\"", "xyz=\"0 0 0.501\"");
  EXPECT_EQ(moved.exit, 1);
  EXPECT_EQ(moved.out, "b.urdf:" + line_of(kArmUrdf, "\"elbow\" type") +
                           ": joint elbow: moved by 1 mm: xyz 0 0 0.5 → 0 0 0.501 m\n");
  EXPECT_EQ(moved.err, "rigor: 1 difference\n");
  EXPECT_EQ(diff_with("value=\"2\"", "value=\"2.5\"").out,
            "b.urdf:3: link base: mass 2 → 2.5 kg (+25 %)\n");
  EXPECT_EQ(diff_with("upper=\"1.6\"", "upper=\"1e16\"").out,
            "b.urdf:" + line_of(kArmUrdf, "<limit lower=\"-1.5") +
                ": joint shoulder: upper limit 1.6 rad → unlimited\n");
  EXPECT_EQ(diff_with("<link name=\"tool\"/>", "<link name=\"tool\"/><link name=\"spare\"/>").out,
            "b.urdf:" + line_of(kArmUrdf, "\"tool\"") + ": link spare: added: 0 kg\n");
}

TEST_F(DiffCli, Json) {
  folder_.put("b.urdf", with(kArmUrdf, "damping=\"0.1\"", "damping=\"0.2\""));
  const Ran ran = diff("a.urdf b.urdf --format json");
  EXPECT_EQ(ran.exit, 1);
  const json report = json::parse(ran.out);
  EXPECT_EQ(report["tool"]["name"], "rigor");
  EXPECT_EQ(report["schema_version"], 1);
  EXPECT_EQ(report["a"]["path"], "a.urdf");
  EXPECT_EQ(report["b"]["model"], "arm");
  EXPECT_EQ(report["summary"], json({{"same", false}, {"differences", 1}}));
  const json& d = report["differences"][0];
  EXPECT_EQ(d["kind"], "damping");
  EXPECT_EQ(d["a"]["subject"], "joint shoulder");
  EXPECT_EQ(std::to_string(d["b"]["line"].get<int>()), line_of(kArmUrdf, "<axis xyz=\"0.48"));
  EXPECT_EQ(d["from"], 0.1);
  EXPECT_EQ(d["to"], 0.2);
  EXPECT_EQ(d["unit"], "N·m·s/rad");
  const Ran same = diff("a.urdf a.sdf --format json");
  EXPECT_EQ(same.exit, 0);
  EXPECT_EQ(json::parse(same.out)["summary"]["same"], true);
}

TEST_F(DiffCli, WrongInvocationsAreTwo) {
  EXPECT_EQ(diff("a.urdf").exit, 2);
  EXPECT_EQ(diff("a.urdf none.urdf").exit, 2);
  EXPECT_EQ(diff("a.urdf a.sdf --format xml").exit, 2);
  EXPECT_EQ(diff("a.urdf a.sdf --strict").exit, 2);
  EXPECT_EQ(diff("a.urdf a.sdf --model leg").exit, 2);
  folder_.put("two.sdf", R"(<sdf version="1.9"><world name="w">
    <model name="arm"><link name="l"/></model><model name="leg"><link name="l"/></model></world></sdf>)");
  const Ran two = diff("two.sdf two.sdf");
  EXPECT_EQ(two.exit, 2);
  EXPECT_NE(two.err.find("--model: arm, leg"), std::string::npos) << two.err;
  EXPECT_EQ(diff("two.sdf two.sdf --model leg").exit, 0);
}

TEST_F(DiffCli, WhatCannotBeReadIsNotTheSame) {
  folder_.put("cut.urdf", "<robot name=\"arm\"><link name=\"a\">");
  folder_.put("note.sdf", "<note/>");
  for (const char* broken : {"cut.urdf", "note.sdf"}) {
    const Ran ran = diff(std::string(broken) + " " + broken);
    EXPECT_EQ(ran.exit, 1) << broken;
    EXPECT_EQ(ran.out, "") << broken;
    EXPECT_NE(ran.err.find(broken), std::string::npos) << ran.err;
  }
}

/// What they tell a simulator is compared where it is told in the same words, else it is said.
TEST_F(DiffCli, WhatIsToldToSimulators) {
  const std::string base = "<link name=\"base\">";
  folder_.put("b.sdf", with(kArmSdf, base, base + "<gravity>false</gravity>"));
  EXPECT_EQ(diff("a.sdf b.sdf").out,
            "b.sdf:" + line_of(kArmSdf, base) + ": link base: gravity default → false\n");
  const Ran mixed = diff("a.urdf b.sdf");
  EXPECT_EQ(mixed.exit, 0);
  EXPECT_NE(mixed.err.find("not compared: contact, gravity"), std::string::npos) << mixed.err;
  const json report = json::parse(diff("a.urdf b.sdf --format json").out);
  EXPECT_EQ(report["not_compared"].size(), 1U);
  EXPECT_EQ(json::parse(diff("a.urdf a.sdf --format json").out)["not_compared"], json::array());
}

TEST_F(DiffCli, AColorThatOnlyOneHasIsReported) {
  const std::string head =
      "<robot name=\"r\"><material name=\"tex\"><texture filename=\"t.png\"/>"
      "</material><link name=\"a\"><visual name=\"v\"><geometry><sphere "
      "radius=\"1\"/></geometry>";
  const std::string end = "</visual></link></robot>";
  folder_.put("red.urdf", head + "<material name=\"m\"><color rgba=\"1 0 0 1\"/></material>" + end);
  folder_.put("none.urdf", head + end);
  folder_.put("texture.urdf", head + "<material name=\"tex\"/>" + end);
  EXPECT_EQ(diff("red.urdf none.urdf").out, "none.urdf:1: visual a/v: color removed: 1 0 0 1\n");
  EXPECT_EQ(diff("none.urdf red.urdf").out, "red.urdf:1: visual a/v: color added: 1 0 0 1\n");
  EXPECT_EQ(diff("red.urdf texture.urdf").out, "") << "the color of a texture is not known";
}

/// MJCF is compared as far as it is read.
TEST_F(DiffCli, OfMjcfItIsSaidWhatIsNotCompared) {
  const std::string plain =
      "<mujoco><worldbody><body name=\"a\"><freejoint/><geom name=\"g\" "
      "size=\".1\"/><site name=\"s\"/></body></worldbody>";
  folder_.put("plain.xml", plain + "</mujoco>");
  folder_.put("gyro.xml", plain + "<sensor><gyro name=\"g\" site=\"s\"/></sensor></mujoco>");
  EXPECT_EQ(diff("plain.xml plain.xml").err, "");
  const Ran ran = diff("gyro.xml plain.xml");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.err.find("rigor: both are MJCF, so not compared: "), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("sensors"), std::string::npos) << ran.err;
  EXPECT_EQ(json::parse(diff("gyro.xml plain.xml --format json").out)["not_compared"].size(), 1U);
  folder_.put("a.sdf", "<sdf version=\"1.9\"><model name=\"a\"><link name=\"a\"/></model></sdf>");
  const Ran mixed = diff("gyro.xml a.sdf");
  EXPECT_NE(mixed.err.find("one is MJCF and one is SDF, so not compared: "), std::string::npos)
      << mixed.err;
}

/// A mesh is one file, whether its model is named by a relative path or by a whole one.
TEST_F(DiffCli, AMeshIsOneFileFromTwoPlaces) {
  folder_.put("w.stl", "solid w\nendsolid w\n");
  const std::string from = "\"w.stl\"";
  folder_.put("here.urdf", kArmUrdf);
  folder_.put("deep/there.urdf", with(kArmUrdf, from, "\"../w.stl\""));
  EXPECT_EQ(diff("deep/there.urdf here.urdf").out, "");
  EXPECT_EQ(diff("deep/there.urdf '" + folder_.path("here.urdf") + "'").out, "");
}

/// Both may be one template.
TEST_F(DiffCli, ArgumentsOfTemplatesCountForTheFileBeforeThem) {
  folder_.put("a.xacro",
              "<robot name=\"a\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:arg name=\"len\" default=\"1\"/>\n"
              "  <link name=\"l\"><collision><geometry><box size=\"1 1 $(arg len)\"/></geometry>"
              "</collision></link>\n</robot>\n");
  const Ran differ = diff("a.xacro len:=2 a.xacro len:=3");
  EXPECT_EQ(differ.exit, 1) << differ.out;
  EXPECT_NE(differ.out.find("1 1 2"), std::string::npos) << differ.out;
  EXPECT_NE(differ.out.find("1 1 3"), std::string::npos) << differ.out;
  EXPECT_EQ(diff("a.xacro len:=2 a.xacro len:=2").exit, 0);
  EXPECT_EQ(diff("a.xacro a.xacro len:=1").exit, 0);
  EXPECT_EQ(diff("a.xacro a.xacro len:=2").exit, 1);
  EXPECT_EQ(diff("len:=2 a.xacro a.xacro").exit, 0);
  const Ran two = folder_.rigor("validate a.xacro len:=2 a.urdf len:=3");
  EXPECT_EQ(two.exit, 2);
  EXPECT_NE(two.err.find("len:=2 and len:=3: all files are given the same arguments"),
            std::string::npos)
      << two.err;
  for (const std::string command : {"fmt --check a.xacro", "explain a.xacro", "new a.xacro",
                                    "merge a.xacro", "schema a.xacro", "init a.xacro", "rules"}) {
    const Ran ran = folder_.rigor(command + " len:=2");
    EXPECT_EQ(ran.exit, 2) << command;
    EXPECT_NE(ran.err.find("takes no arguments of templates, as len:=2 is one"), std::string::npos)
        << ran.err;
  }
}

}  // namespace
}  // namespace rigor::test
