// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules that compare one part of a robot with all others: how many others it takes, and how loudly they speak.

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules::assembly_slips {
namespace {

using Loudness = std::vector<Severity>;

const Loudness kQuiet;
const Loudness kWarned{Severity::kWarning};
const Loudness kInformed{Severity::kInfo};

/// Of one rule in a URDF.
Loudness said(const std::string& rule, const std::string& inside) {
  const std::string text = "<robot name='r'>" + inside + "</robot>";
  const MemoryDisk disk(std::map<std::string, std::string>{{"a.urdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  Loudness severities;
  const ValidateResult result = validate(environment, {.paths = {"a.urdf"}}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == rule) severities.push_back(diagnostic.severity);
  }
  return severities;
}

std::string link(const std::string& name, const std::string& shape,
                 const std::string& at = "0 0 0") {
  return "<link name='" + name +
         "'><inertial><mass value='0.1'/><inertia ixx='1e-4' ixy='0' ixz='0' iyy='1e-4' iyz='0' "
         "izz='1e-4'/></inertial><collision><origin xyz='" +
         at + "'/><geometry>" + shape + "</geometry></collision></link>";
}

std::string joint(const std::string& child, const std::string& parent, const std::string& at,
                  const std::string& limit = "lower='-1' upper='2'") {
  return "<joint name='" + child + "_joint' type='revolute'><parent link='" + parent +
         "'/><child link='" + child + "'/><origin xyz='" + at +
         "'/><axis xyz='0 1 0'/><limit effort='10' velocity='2' " + limit + "/></joint>";
}

/// Rods of 0.3 m, one upon the other; the elbow is where it is said to be.
std::string arm(const std::string& elbow, int links) {
  std::string text = link("base", "<box size='0.2 0.2 0.1'/>");
  const std::string rod = "<box size='0.04 0.04 0.3'/>";
  std::string parent = "base";
  for (int i = 0; i < links; ++i) {
    const std::string name = std::string(1, static_cast<char>('p' + i)) + "_rod";
    text += link(name, rod, "0 0 0.15");
    text += joint(name, parent, i == 0 ? "0 0 0.05" : i == 1 ? elbow : "0 0 0.3");
    parent = name;
  }
  return text;
}

TEST(AssemblySlips, ALinkIsComparedWithHowTheOthersAreJoined) {
  const std::string rule = "link-off-its-parent";
  EXPECT_EQ(said(rule, arm("0 0 0.3", 4)), kQuiet);
  EXPECT_EQ(said(rule, arm("0 0 -0.3", 4)), kWarned);
  // Inside of its parent, as some links are by design.
  EXPECT_EQ(said(rule, arm("0 0 0.03", 4)), kInformed);
  // Left out, nobody knows what it was; nor what is usual, of two joints.
  EXPECT_EQ(said(rule, arm("0 0 0", 4)), kInformed);
  EXPECT_EQ(said(rule, arm("0 0 -0.3", 2)), kQuiet);
}

/// Rotors of 0.1 m, and one of another radius.
std::string rotors(int count, const std::string& radius) {
  std::string text = link("frame", "<box size='0.5 0.5 0.1'/>");
  for (int i = 0; i < count; ++i) {
    const std::string name = "rotor_" + std::to_string(i);
    const std::string at = (i % 2 == 0 ? "0.2 " : "-0.2 ") + std::string(i < 2 ? "0.2" : "-0.2");
    text += link(name, "<cylinder radius='" + (i == 1 ? radius : "0.1") + "' length='0.02'/>",
                 "0 0 0.01");
    text += joint(name, "frame", at + " 0.06");
  }
  return text;
}

TEST(AssemblySlips, AnOddPartIsGradedByHowManyAreAlike) {
  const std::string rule = "sibling-value-differs";
  EXPECT_EQ(said(rule, rotors(4, "0.1")), kQuiet);
  EXPECT_EQ(said(rule, rotors(4, "0.05")), kWarned);
  EXPECT_EQ(said(rule, rotors(3, "0.05")), kInformed);
  EXPECT_EQ(said(rule, rotors(4, "0.13")), kQuiet);  // no slip that is known
  EXPECT_EQ(said(rule, rotors(2, "0.05")), kInformed);
  EXPECT_EQ(said(rule, rotors(2, "0.07")), kQuiet);
}

std::string meshes(int count, const std::string& scale) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const std::string name = "part_" + std::string(1, static_cast<char>('p' + i));
    text += link(name, "<mesh filename='package://r/" + name + ".stl' scale='" +
                           (i == 1 ? scale : "0.001 0.001 0.001") + "'/>");
    if (i > 0) text += joint(name, "part_p", "0 0 0");
  }
  return text;
}

/// Four rotors, not in a square; the first is where it is said to be.
std::string drone(const std::string& first) {
  std::string text = link("base", "<box size='0.1 0.1 0.05'/>");
  const std::vector<std::string> places{first, "-0.13 -0.2 0.023", "0.13 0.22 0.023",
                                        "0.13 -0.22 0.023"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string name = "rotor_" + std::to_string(i);
    text += link(name, "<cylinder radius='0.05' length='0.01'/>") + joint(name, "base", places[i]);
  }
  return text;
}

TEST(AssemblySlips, APlaceIsComparedWithThoseOfTwoSizes) {
  const std::string rule = "sibling-value-differs";
  EXPECT_EQ(said(rule, drone("-0.13 0.2 0.023")), kQuiet);
  EXPECT_EQ(said(rule, drone("-0.013 0.02 0.0023")), kInformed);
  EXPECT_EQ(said(rule, drone("-0.013 0.02 0.01")), kQuiet);  // no slip of the decimal point
}

/// A rod of 0.4 m in its link.
std::string rod(const std::string& at, const std::string& turned) {
  return "<link name='rod'><collision><origin xyz='" + at + "' rpy='" + turned +
         "'/><geometry><cylinder radius='0.02' length='0.4'/></geometry></collision></link>";
}

TEST(AssemblySlips, ACylinderBeginsAtItsLink) {
  const std::string rule = "shape-rotation-slip";
  EXPECT_EQ(said(rule, rod("0.2 0 0", "0 0 0")), kWarned);
  EXPECT_EQ(said(rule, rod("0 -0.2 0", "0 1.5708 0")), kWarned);
  EXPECT_EQ(said(rule, rod("0 0 0.2", "1.5708 0 0")), kWarned);
  EXPECT_EQ(said(rule, rod("0.2 0 0", "0 1.5708 0")), kQuiet);
  EXPECT_EQ(said(rule, rod("0 -0.2 0", "1.5708 0 0")), kQuiet);
  EXPECT_EQ(said(rule, rod("0 0 0.2", "0 0 0")), kQuiet);
  EXPECT_EQ(said(rule, rod("0.25 0 0", "0 0 0")), kQuiet);     // not half of it
  EXPECT_EQ(said(rule, rod("0.14 0.14 0", "0 0 0")), kQuiet);  // along no axis
}

TEST(AssemblySlips, AScaleIsComparedWithThoseOfThreeMeshes) {
  const std::string rule = "mesh-scale-differs";
  EXPECT_EQ(said(rule, meshes(4, "0.001 0.001 0.001")), kQuiet);
  EXPECT_EQ(said(rule, meshes(4, "0.01 0.01 0.01")), kWarned);
  EXPECT_EQ(said(rule, meshes(4, "-0.001 0.001 0.001")), kQuiet);
  EXPECT_EQ(said(rule, meshes(4, "0.002 0.002 0.002")), kQuiet);
  EXPECT_EQ(said(rule, meshes(4, "1 1 1")), kInformed);  // as its file may be in meters
  EXPECT_EQ(said(rule, meshes(3, "0.01 0.01 0.01")), kQuiet);
}

std::string limited(const std::string& limit) {
  return link("base", "<box size='0.2 0.2 0.1'/>") + link("p", "<box size='0.1 0.1 0.1'/>") +
         link("q", "<box size='0.1 0.2 0.1'/>") + link("s", "<box size='0.2 0.1 0.1'/>") +
         link("t", "<box size='0.3 0.1 0.1'/>") + joint("p", "base", "0 0 0.1", limit) +
         joint("q", "p", "0 0 0.1") + joint("s", "q", "0 0 0.1") + joint("t", "s", "0 0 0.1");
}

TEST(AssemblySlips, LimitsAreComparedWithThoseOfTheOtherJoints) {
  EXPECT_EQ(said("limit-equal", limited("lower='1' upper='1'")), kWarned);
  EXPECT_EQ(said("limit-excludes-zero", limited("lower='1' upper='2'")), kWarned);
  EXPECT_EQ(said("limit-excludes-zero", limited("lower='0.1' upper='2'")), kInformed);
  EXPECT_EQ(said("limit-excludes-zero", limited("lower='-2' upper='-1'")), kInformed);
}

/// A link of 1 kg with these signs of its products of inertia.
std::string shank(const std::string& name, int xy, int xz, int yz) {
  const auto product = [](int sign, const char* size) {
    return (sign < 0 ? "-" : "") + std::string(size);
  };
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='0.02' iyy='0.022' izz='0.009' ixy='" +
         product(xy, "0.002") + "' ixz='" + product(xz, "0.001") + "' iyz='" +
         product(yz, "0.003") + "'/></inertial></link>";
}

TEST(AssemblySlips, ProductsOfAMirrorImageChangeInPairs) {
  // A reflection in a plane through the axes, or half a turn about one, negates two products; nothing else that
  // maps the axes to themselves is another pattern.
  for (int signs = 0; signs < 8; ++signs) {
    const auto sign = [signs](int bit) { return (signs >> bit & 1) != 0 ? -1 : 1; };
    const int negated = (signs & 1) + (signs >> 1 & 1) + (signs >> 2 & 1);
    const std::string legs = shank("shank_1", 1, 1, 1) + shank("shank_2", 1, 1, 1) +
                             shank("shank_3", sign(0), sign(1), sign(2));
    EXPECT_EQ(said("products-of-inertia-negated", legs), negated % 2 == 0 ? kQuiet : kWarned)
        << signs;
  }
}

TEST(AssemblySlips, ArmsOfADuoMayBeAnywhere) {
  const std::string box = "<box size='0.1 0.2 0.3'/>";
  const auto duo = [&](const std::string& carrier) {
    return carrier + link("left_arm", box, "0 0 0.2") + link("right_arm", box, "0 0 0.2") +
           joint("left_arm", "table", "0 0 0") + joint("right_arm", "table", "0 1 0");
  };
  EXPECT_EQ(said("twin-value-differs", duo("<link name='table'/>")), kQuiet);
  EXPECT_EQ(said("sibling-value-differs", duo("<link name='table'/>")), kQuiet);
}

TEST(AssemblySlips, FramesOfAPairMayBeAnywhere) {
  const std::string box = "<box size='0.1 0.2 0.3'/>";
  const auto camera = [](const std::string& side, const std::string& origin) {
    return "<link name='" + side +
           "_camera'><inertial><mass value='0.01'/><inertia ixx='0.001' ixy='0' ixz='0' "
           "iyy='0.001' iyz='0' izz='0.001'/></inertial></link>" +
           joint(side + "_camera", "head", origin);
  };
  const std::string stereo =
      link("head", box, "0 0 0.2") + camera("left", "0 0 0") + camera("right", "0 0.09 0");
  EXPECT_EQ(said("twin-value-differs", stereo), kQuiet);
  EXPECT_EQ(said("sibling-value-differs", stereo), kQuiet);
}

}  // namespace
}  // namespace rigor::rules::assembly_slips
