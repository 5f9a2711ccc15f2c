// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The printed reason fits the case: the format of the file, its version, the value, the consumer.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/grouping.h>

namespace rigor::rules {
namespace {

struct Reported {
  std::string why;
  std::string help;
  Severity severity = Severity::kInfo;
};

/// What is printed of the first finding of the rule; empty when there is none.
Reported reported(const std::string& rule, const std::string& path, const std::string& text) {
  const MemoryDisk disk(std::map<std::string, std::string>{{path, text}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {path}}, sources);
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule != rule) continue;
    return {std::string(why_of(found)), std::string(help_of(found)), found.severity};
  }
  return {};
}

Reported of_sdf(const std::string& rule, const std::string& inside,
                const std::string& version = "1.9") {
  return reported(rule, "a.sdf",
                  "<sdf version='" + version + "'><model name='m'>" + inside + "</model></sdf>");
}

Reported of_urdf(const std::string& rule, const std::string& inside) {
  return reported(rule, "a.urdf", "<robot name='r'>" + inside + "</robot>");
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kSphere = "<geometry><sphere><radius>1</radius></sphere></geometry>";

TEST(Reason, OfAUrdfNamesItsReaders) {
  const Reported type = of_urdf("joint-type-unknown",
                                "<link name='a'/><link name='b'/><joint name='j' type='hinge'>"
                                "<parent link='a'/><child link='b'/></joint>");
  EXPECT_EQ(type.why, "urdfdom rejects the robot.");
  EXPECT_TRUE(mentions(of_urdf("value-malformed",
                               "<link name='a'><visual><origin xyz='1 2 3 4'/><geometry><sphere "
                               "radius='1'/></geometry></visual></link>")
                           .why,
                       "urdfdom"));
  EXPECT_TRUE(mentions(of_sdf("joint-type-unknown",
                              "<link name='a'/><link name='b'/><joint name='j' type='hinge'>"
                              "<parent>a</parent><child>b</child></joint>")
                           .why,
                       "libsdformat"));
}

TEST(Reason, OfAMisspeltColorIsWhatTheReaderPrints) {
  const Reported color =
      of_urdf("unknown-attribute",
              "<link name='a'/><material name='red'><color rgb='1 0 0 1'/></material>");
  EXPECT_TRUE(mentions(color.why, "Material [red] color has no rgba"));
  EXPECT_EQ(color.help, "did you mean 'rgba'?");
}

TEST(Reason, OfANestedCommentIsTheOneThatIsOpen) {
  const Reported nested =
      of_sdf("xml-double-hyphen-in-comment", "<link name='a'/><!--a --> <!--b <!--c /-->");
  EXPECT_TRUE(mentions(nested.help, "close it with '-->'"));
  const Reported line = of_sdf("xml-double-hyphen-in-comment", "<link name='a'/><!-- -- -->");
  EXPECT_TRUE(mentions(line.help, "====="));
}

TEST(Reason, OfAMissingElementIsAboutThatElement) {
  EXPECT_TRUE(mentions(of_urdf("missing-element", "<joint name='j' type='fixed'/>").why, "links"));
  const Reported parent = of_urdf(
      "missing-element", "<link name='a'/><joint name='j' type='fixed'><child link='a'/></joint>");
  EXPECT_TRUE(mentions(parent.why, "parent"));
  EXPECT_EQ(parent.help, "add <parent>");
}

TEST(Reason, OfColorsGoesByTheirScale) {
  const auto light = [](const std::string& diffuse) {
    return of_sdf("value-bad-color", "<link name='l'><light name='s' type='point'><diffuse>" +
                                         diffuse + "</diffuse></light></link>");
  };
  EXPECT_EQ(light("8 0.8 0.8 1").help, "write parts from 0 to 1");
  EXPECT_EQ(light("128 192 210 0.1").help, "divide the parts by 255");
  EXPECT_EQ(of_urdf("value-bad-color",
                    "<material name='g'><color rgba='128 0 0 1'/></material><link name='a'/>")
                .severity,
            Severity::kWarning);
}

TEST(Reason, OfASiblingNameGoesByTheVersion) {
  const std::string named =
      "<link name='a'/><link name='b'/><joint name='b' type='revolute'>"
      "<parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>";
  const Reported old = of_sdf("duplicate-sibling-name", named, "1.5");
  EXPECT_EQ(old.severity, Severity::kWarning);
  EXPECT_TRUE(mentions(old.why, "renames the joint"));
  EXPECT_EQ(old.help, "rename one of them, for example by the suffix _joint");
  EXPECT_EQ(of_sdf("duplicate-sibling-name", named, "1.7").severity, Severity::kError);
  const Reported visual = of_sdf(
      "duplicate-sibling-name", "<link name='l'><collision name='v'>" + kSphere +
                                    "</collision><visual name='v'>" + kSphere + "</visual></link>");
  EXPECT_TRUE(mentions(visual.why, "simulators load the file"));
}

TEST(Reason, OfATextAfterANumberIsWhatIsRead) {
  const auto mass = [](const std::string& text) {
    return of_sdf("value-trailing-text",
                  "<link name='l'><inertial><mass>" + text + "</mass></inertial></link>");
  };
  EXPECT_EQ(mass("0.5kg").why, "libsdformat reads 0.5, and ignores the rest silently.");
  EXPECT_EQ(mass("0.5kg").severity, Severity::kWarning);  // what is meant
  EXPECT_EQ(mass("0.5g").severity, Severity::kError);     // a thousand times what is meant
  const Reported urdf =
      of_urdf("value-trailing-text",
              "<link name='a'><inertial><mass value='0.5kg'/><inertia ixx='1' iyy='1' izz='1' "
              "ixy='0' ixz='0' iyz='0'/></inertial></link>");
  EXPECT_TRUE(mentions(urdf.why, "drops the whole <inertial>"));
  EXPECT_EQ(urdf.severity, Severity::kError);
}

TEST(Reason, OfAMissingFrameGoesByWhatIsPlaced) {
  const Reported link = of_sdf("relative-to-missing",
                               "<link name='l'><pose relative_to='f'>0 0 0 0 0 0</pose></link>");
  EXPECT_TRUE(mentions(link.why, "rejects"));
  const Reported visual = of_sdf("relative-to-missing",
                                 "<link name='l'><visual name='v'><pose relative_to='f'>0 0 0 0 "
                                 "0 0</pose>" +
                                     kSphere + "</visual></link>");
  EXPECT_TRUE(mentions(visual.why, "takes the numbers"));
}

TEST(Reason, OfAMisplacedElementIsTheNearestThatTakesIt) {
  EXPECT_EQ(of_sdf("misplaced-element", "<link name='l'><static>true</static></link>").help,
            "move it to the <model> around it");
}

TEST(Reason, OfAnEmptyElementIsThatNothingIsLost) {
  const auto framed = [](const std::string& frame) {
    return of_sdf("element-removed-in-version",
                  "<link name='l'><pose frame='" + frame + "'>0 0 1 0 0 0</pose></link>", "1.8");
  };
  EXPECT_EQ(framed("").severity, Severity::kInfo);
  EXPECT_EQ(framed("base").severity, Severity::kWarning);
  const auto block = [](const std::string& inside) {
    return of_urdf("gazebo-reference-missing",
                   "<link name='a'/><gazebo reference='tool'>" + inside + "</gazebo>");
  };
  EXPECT_EQ(block("").severity, Severity::kInfo);
  EXPECT_EQ(block("<mu1>1</mu1>").severity, Severity::kWarning);
  EXPECT_EQ(block("<sensor name='s' type='imu'/>").severity, Severity::kWarning);
}

TEST(Reason, OfAWrongSpringNamesNoOtherQuantity) {
  const Reported stop =
      of_urdf("gazebo-element-unknown",
              "<link name='a'/><link name='b'/><joint name='j' type='continuous'><parent link='a'/>"
              "<child link='b'/></joint><gazebo reference='j'><stopKp value='1e6'/></gazebo>");
  EXPECT_FALSE(mentions(stop.help, "did you mean"));
}

TEST(Reason, OfAPlaceholderTensorNamesNoUnit) {
  const Reported placeholder = of_sdf(
      "inertia-geometry-mismatch",
      "<link name='l'><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>0</izz>"
      "</inertia></inertial><collision name='c'><geometry><box><size>0.1 0.1 0.1</size></box>"
      "</geometry></collision></link>");
  EXPECT_FALSE(mentions(placeholder.help, "cm²")) << placeholder.help;
}

TEST(Reason, OfDegreesInAnIncludeIsTheUnit) {
  const auto included = [](const std::string& version) {
    return reported("element-newer-than-version", "a.sdf",
                    "<sdf version='" + version +
                        "'><world name='w'><include><uri>https://a.org/b</uri><pose "
                        "degrees='true'>0 0 0 0 0 90</pose></include></world></sdf>");
  };
  EXPECT_TRUE(mentions(included("1.6").why, "radians"));
  EXPECT_TRUE(included("1.9").why.empty());
}

// Lines of models that were reported once and are right.

TEST(Reason, OfTextThatIsAValueIsTheElementForIt) {
  const auto box = of_sdf("text-between-elements",
                          "<link name='l'><visual name='v'><geometry><box>1 1 1</box></geometry>"
                          "</visual></link>");
  EXPECT_EQ(box.help, "write <size>1 1 1</size>");
  const auto stray = of_sdf("text-between-elements", "<link name='l'>stray</link>");
  EXPECT_TRUE(mentions(stray.help, "Remove the characters"));
}

TEST(Reason, OfAPartOfAnMjcfIsTheFileThatIncludesIt) {
  const Reported part = reported("unknown-root", "a.xml", "<mujocoinclude/>");
  EXPECT_EQ(part.severity, Severity::kInfo);
  EXPECT_TRUE(mentions(part.why, "MuJoCo"));
  EXPECT_EQ(reported("unknown-root", "a.xml", "<mujocos/>").severity, Severity::kError);
}

/// Sensors without a world are included by the file that has the bodies.
TEST(Unreported, IsWhatAPartOfAnMjcfRefersTo) {
  const std::string sensor = "<sensor><touch name='t' site='palm'/></sensor>";
  const std::string rule = "mjcf-reference-missing";
  EXPECT_TRUE(reported(rule, "a.xml", "<mujoco>" + sensor + "</mujoco>").why.empty());
  EXPECT_FALSE(reported(rule, "a.xml",
                        "<mujoco><worldbody><body name='b'/></worldbody>" + sensor + "</mujoco>")
                   .why.empty());
}

TEST(Unreported, IsATensorThatIsNegativeByRounding) {
  EXPECT_TRUE(of_urdf("inertia-not-positive-definite",
                      "<link name='a'/><link name='b'><inertial><mass value='1'/><inertia "
                      "ixx='0.01' iyy='0.01' izz='-1e-35' ixy='0' ixz='0' iyz='0'/></inertial>"
                      "</link><joint name='j' type='fixed'><parent link='a'/><child link='b'/>"
                      "</joint>")
                  .why.empty());
}

TEST(Unreported, IsAPlaceholderOfAnExporterInAUri) {
  EXPECT_TRUE(of_sdf("asset-not-found",
                     "<link name='l'><visual name='v'>" + kSphere +
                         "<material><script><uri>__default__</uri><name>__default__</name></script>"
                         "</material></visual></link>")
                  .why.empty());
}

TEST(Unreported, IsAWristThatTurnsRound) {
  const auto joint = [](const std::string& limits) {
    return of_urdf("wheel-axis-mismatch",
                   "<link name='a'/><link name='b'><collision><origin rpy='1.5708 0 0'/><geometry>"
                   "<cylinder radius='0.1' length='0.05'/></geometry></collision></link><joint "
                   "name='j' " +
                       limits + "<parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint>");
  };
  EXPECT_TRUE(
      joint("type='revolute'><limit lower='-6.2832' upper='6.2832' effort='1' velocity='1'/>")
          .why.empty());
  EXPECT_FALSE(joint("type='continuous'>").why.empty());
}

TEST(Unreported, IsAGearboxAsAClosedChain) {
  EXPECT_TRUE(of_sdf("closed-chain",
                     "<link name='base'/><link name='a'/><link name='b'/>"
                     "<joint name='j' type='revolute'><parent>base</parent><child>a</child><axis>"
                     "<xyz>0 0 1</xyz></axis></joint>"
                     "<joint name='k' type='revolute'><parent>base</parent><child>b</child><axis>"
                     "<xyz>0 0 1</xyz></axis></joint>"
                     "<joint name='g' type='gearbox'><parent>a</parent><child>b</child>"
                     "<gearbox_reference_body>base</gearbox_reference_body><axis><xyz>0 0 1</xyz>"
                     "</axis><axis2><xyz>0 0 1</xyz></axis2></joint>")
                  .why.empty());
}

TEST(Unreported, IsASmallMomentBesideTwoThatAreTooLarge) {
  const std::string sphere =
      "<collision name='c'><geometry><sphere><radius>0.0285</radius></sphere></geometry>"
      "</collision></link>";
  const std::string inertial =
      "<link name='l'><inertial><mass>0.04</mass><inertia><ixx>0.00002166</ixx><iyy>2166</iyy>"
      "<izz>2166</izz></inertia></inertial>" +
      sphere;
  EXPECT_TRUE(of_sdf("inertia-moment-near-zero", inertial).why.empty());
  EXPECT_FALSE(of_sdf("inertia-geometry-mismatch", inertial).why.empty());
}

TEST(Unreported, IsAFileOfColorsThatXacroIncludes) {
  const std::string colors = "<material name='m'><color rgba='0 0 0 1'/></material></robot>";
  EXPECT_TRUE(reported("missing-element", "a.urdf",
                       "<robot name='c' xmlns:xacro='http://ros.org/wiki/xacro'>" + colors)
                  .why.empty());
  EXPECT_FALSE(reported("missing-element", "a.urdf", "<robot name='c'>" + colors).why.empty());
}

TEST(Unreported, IsAPathThatFindWrites) {
  const std::string mesh =
      "<link name='a'><visual><geometry><mesh filename='file://@/meshes/a.stl'/></geometry>"
      "</visual></link></robot>";
  const auto with = [&mesh](const std::string& folder) {
    std::string text = "<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'>" + mesh;
    text.replace(text.find('@'), 1, folder);
    const MemoryDisk disk(std::map<std::string, std::string>{
        {"/ws/arm/package.xml", "<package><name>arm</name></package>"},
        {"/ws/arm/urdf/a.urdf.xacro", text}});
    const Environment environment(disk, {});
    Sources sources;
    const ValidateResult result =
        validate(environment, {.paths = {"/ws/arm/urdf/a.urdf.xacro"}}, sources);
    std::size_t count = 0;
    for (const Diagnostic& found : result.diagnostics.list()) {
      count += found.rule == "uri-absolute-path" ? 1U : 0U;
    }
    return count;
  };
  EXPECT_EQ(with("$(find arm)"), 0U);
  EXPECT_EQ(with("/home/me/arm"), 1U);
}

/// A cause that comes after a thousand places of another is listed all the same.
TEST(Listed, AreCausesAndNotPlaces) {
  std::string text = "<sdf version='1.9'><model name='m'><link name='l'>";
  for (int i = 0; i < 1500; ++i) text += "<hue>1</hue>";
  text += "<shade>1</shade></link></model></sdf>";
  const MemoryDisk disk(std::map<std::string, std::string>{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
  std::size_t shades = 0;
  std::size_t hues = 0;
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule != "unknown-element") continue;
    shades += found.message.find("<shade>") != std::string::npos ? 1U : 0U;
    hues += found.message.find("<hue>") != std::string::npos ? 1U : 0U;
  }
  EXPECT_EQ(shades, 1U);
  EXPECT_EQ(hues, 1500U);
}

/// A placeholder that several links have is one cause, whatever their masses are.
TEST(Listed, IsAPlaceholderOnce) {
  const auto link = [](const std::string& name, const std::string& mass,
                       const std::string& moment) {
    return "<link name='" + name + "'><inertial><mass>" + mass + "</mass><inertia><ixx>" + moment +
           "</ixx><iyy>" + moment + "</iyy><izz>" + moment +
           "</izz></inertia></inertial><collision name='c'><geometry><sphere><radius>0.03</radius>"
           "</sphere></geometry></collision></link>";
  };
  const auto causes = [](const std::string& rule, const std::string& inside) {
    const MemoryDisk disk(std::map<std::string, std::string>{
        {"a.sdf", "<sdf version='1.9'><model name='m'>" + inside + "</model></sdf>"}});
    const Environment environment(disk, {});
    Sources sources;
    const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
    const Diagnostics shown = grouped(result.diagnostics);
    return std::count_if(shown.list().begin(), shown.list().end(),
                         [&](const Diagnostic& found) { return found.rule == rule; });
  };
  EXPECT_EQ(causes("inertia-identity", link("a", "0.1", "1") + link("b", "0.2", "1")), 1);
  EXPECT_EQ(
      causes("inertia-geometry-mismatch", link("a", "0.1", "0.01") + link("b", "0.2", "0.01")), 1);
  EXPECT_EQ(
      causes("inertia-geometry-mismatch", link("a", "0.1", "0.01") + link("b", "0.2", "0.001")), 2);
}

}  // namespace
}  // namespace rigor::rules
