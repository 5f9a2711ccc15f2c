// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules that compare one part of a robot with all others: how many others it takes, and how loudly they speak.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
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

/// An arm whose second rod slides, and is beside the first: it meets it within these limits, or does not.
TEST(AssemblySlips, ASliderMayBeApartAtZero) {
  const std::string rule = "link-off-its-parent";
  const auto slider = [](const std::string& limit) {
    std::string text = arm("0.3 0 0", 4);
    const std::size_t at = text.find("q_rod_joint");
    text.replace(text.find("revolute", at), 8, "prismatic");
    text.replace(text.find("0 1 0", at), 5, "1 0 0");
    return text.replace(text.find("lower='-1' upper='2'", at), 20, limit);
  };
  EXPECT_EQ(said(rule, slider("lower='-0.1' upper='0'")), kWarned);
  EXPECT_EQ(said(rule, slider("lower='-0.3' upper='0'")), kQuiet);
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

/// A bucket that is hinged below the end of a boom of a meter, to its outside.
std::string excavator(const std::string& limit, const std::string& type = "revolute") {
  std::string curl = joint("bucket", "boom", "0.5 0 0", limit);
  curl.replace(curl.find("revolute"), 8, type);
  return link("boom", "<box size='1 0.1 0.2'/>") +
         link("bucket", "<box size='0.4 0.1 0.3'/>", "0.2 0 -0.2") + curl;
}

TEST(AssemblySlips, ALinkIsNotDrivenIntoItsParent) {
  const std::string rule = "limits-drive-into-parent";
  EXPECT_EQ(said(rule, excavator("lower='-2.4' upper='0'")), kQuiet);
  EXPECT_EQ(said(rule, excavator("lower='0' upper='2.4'")), kWarned);
  EXPECT_EQ(said(rule, excavator("lower='0' upper='1.2'")), kQuiet);        // before it is inside
  EXPECT_EQ(said(rule, excavator("lower='-2.4' upper='2.4'")), kInformed);  // nor the other way
  EXPECT_EQ(said(rule, excavator("lower='-1e9' upper='1e9'")), kQuiet);     // no limits
  EXPECT_EQ(said(rule, excavator("lower='0' upper='0.6'", "prismatic")), kQuiet);  // sideways
}

/// Fingers on a palm, by their limits.
std::string fingers(const std::vector<std::string>& limits) {
  std::string text = link("palm", "<box size='0.1 0.1 0.1'/>");
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const std::string name = "finger_" + std::string(1, static_cast<char>('p' + i));
    text += link(name, "<box size='0.01 0.01 0.05'/>") + joint(name, "palm", "0 0 0.1", limits[i]);
  }
  return text;
}

TEST(AssemblySlips, LimitsHaveTheSignsOfLikeJoints) {
  const std::string rule = "limits-opposed";
  const std::string closed = "lower='-0.2' upper='1.6'", opened = "lower='-1.6' upper='0.2'";
  EXPECT_EQ(said(rule, fingers({closed, closed, closed})), kQuiet);
  EXPECT_EQ(said(rule, fingers({closed, opened, closed})), kWarned);
  EXPECT_EQ(said(rule, fingers({closed, opened})), kQuiet);
  EXPECT_EQ(said(rule, fingers({closed, opened, closed, opened})), kQuiet);
  EXPECT_EQ(said(rule, fingers({closed, "lower='-1.7' upper='0.2'", closed})), kQuiet);
  const std::string half = "lower='0' upper='1.6'", other_half = "lower='-1.6' upper='0'";
  EXPECT_EQ(said(rule, fingers({half, other_half, half})), kQuiet);  // a thumb
  // The axis of the one is negated as well: it moves as the others do.
  std::string turned = fingers({closed, opened, closed});
  turned.replace(turned.find("0 1 0", turned.find("finger_q_joint")), 5, "0 -1 0");
  EXPECT_EQ(said(rule, turned), kQuiet);
}

/// Joints on both sides of a body, by the limits of the left and of the right.
std::string sides(const std::vector<std::pair<std::string, std::string>>& limits) {
  std::string text = link("body", "<box size='0.1 0.1 0.1'/>");
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const std::string part = "_" + std::string(1, static_cast<char>('p' + i));
    const std::string box = "<box size='0.01 0.01 0.05'/>";
    text += link("left" + part, box) + joint("left" + part, "body", "0 0.1 0", limits[i].first);
    text += link("right" + part, box) + joint("right" + part, "body", "0 -0.1 0", limits[i].second);
  }
  return text;
}

TEST(AssemblySlips, LimitsOfTwoSidesAreAsInOtherPairs) {
  const std::string rule = "limits-opposed";
  const std::string p = "lower='-0.2' upper='1.6'", q = "lower='-0.3' upper='1.7'",
                    r = "lower='-0.4' upper='1.8'", opposed = "lower='-1.8' upper='0.4'";
  EXPECT_EQ(said(rule, sides({{p, p}, {q, q}, {r, r}})), kQuiet);
  EXPECT_EQ(said(rule, sides({{p, p}, {q, q}, {r, opposed}})), kInformed);
  EXPECT_EQ(said(rule, sides({{p, p}, {r, opposed}})), kQuiet);
}

/// A drawer that slides along x in its cabinet, or out of it.
std::string drawer(const std::string& at, const std::string& limit) {
  std::string slide = joint("drawer", "cabinet", at, limit);
  slide.replace(slide.find("revolute"), 8, "prismatic");
  slide.replace(slide.find("0 1 0"), 5, "1 0 0");
  return link("cabinet", "<box size='0.5 0.5 0.5'/>") +
         link("drawer", "<box size='0.4 0.3 0.1'/>") + slide;
}

TEST(AssemblySlips, ADrawerMayBeInsideItsCabinet) {
  const std::string rule = "limits-drive-into-parent";
  EXPECT_EQ(said(rule, drawer("0.5 0 0", "lower='-0.5' upper='0'")), kInformed);
  EXPECT_EQ(said(rule, drawer("0.5 0 0", "lower='0' upper='0.5'")), kQuiet);
  EXPECT_EQ(said(rule, drawer("0 0 0", "lower='0' upper='0.5'")), kQuiet);  // inside at zero
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

/// Cameras of 1 cm, joined so to a rail that is not drawn.
std::string eyes(const std::string& left, const std::string& right, const std::string& type) {
  const auto eye = [&](const std::string& side, const std::string& origin) {
    std::string text =
        link(side + "_cam", "<box size='0.01 0.01 0.01'/>") + joint(side + "_cam", "rail", origin);
    const std::size_t at = text.find("revolute");
    return at == text.npos ? text : text.replace(at, 8, type);
  };
  return link("base", "<box size='0.01 0.01 0.01'/>") + "<link name='rail'/>" +
         joint("rail", "base", "0 0 0") + eye("l", left) + eye("r", right);
}

TEST(AssemblySlips, ABaselineIsNoSlip) {
  for (const char* rule :
       {"sibling-value-differs", "twin-value-differs", "link-misplaced", "link-off-its-parent"}) {
    EXPECT_EQ(said(rule, eyes("0 0 0", "0 -0.09 0", "fixed")), kQuiet) << rule;
  }
  // Of parts that move, one at the origin was left out.
  EXPECT_NE(said("sibling-value-differs", eyes("0 0 0", "0 -0.09 0", "revolute")), kQuiet);
  EXPECT_NE(said("link-misplaced", eyes("0 0.001 0", "0 -9 0", "fixed")), kQuiet);
}

}  // namespace
}  // namespace rigor::rules::assembly_slips
