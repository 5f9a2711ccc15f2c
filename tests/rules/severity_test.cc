// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules whose findings are graded by their effect: the same defect, small and large.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

using Severities = std::vector<Severity>;

struct Asked {
  std::vector<Target> targets = {};
  std::optional<Severity> set = std::nullopt;  ///< by the user
};

/// Of the rule's findings in the file, in their order.
Severities severities(const std::string& rule, const std::string& path, const std::string& text,
                      const Asked& options = {}) {
  const MemoryDisk disk(std::map<std::string, std::string>{{path, text}});
  const Environment environment(disk, {});
  Sources sources;
  ValidateOptions validation{.paths = {path}, .selection = {.targets = options.targets}};
  if (options.set) validation.selection.severity = {{rule, *options.set}};
  Severities found;
  const ValidateResult result = validate(environment, validation, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == rule) found.push_back(diagnostic.severity);
  }
  return found;
}

Severities in_sdf(const std::string& rule, const std::string& text, const Asked& options = {}) {
  return severities(rule, "a.sdf", text, options);
}
Severities in_urdf(const std::string& rule, const std::string& text, const Asked& options = {}) {
  return severities(rule, "a.urdf", text, options);
}

const Severities kOneError{Severity::kError};
const Severities kOneWarning{Severity::kWarning};
const Severities kOneInfo{Severity::kInfo};
const Severities kNothing;

std::string sdf_of(const std::string& inside) {
  return "<sdf version='1.9'><model name='m'>" + inside + "</model></sdf>";
}

/// A box of 1 m, at the origin of its link.
std::string boxed(const std::string& inertial) {
  return sdf_of("<link name='l'><inertial>" + inertial +
                "</inertial><collision name='c'><geometry><box><size>1 1 1</size></box></geometry>"
                "</collision></link>");
}

std::string urdf_of(const std::string& joint) {
  return "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='revolute'>"
         "<parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
         "<limit lower='-1' upper='1' effort='1' velocity='1'/>" +
         joint + "</joint></robot>";
}

TEST(Severity, OfSiblingNamesGoesByWhetherTheyAreFrames) {
  const std::string geometry = "<geometry><sphere><radius>1</radius></sphere></geometry>";
  EXPECT_EQ(in_sdf("duplicate-sibling-name",
                   sdf_of("<link name='l'><visual name='v'>" + geometry +
                          "</visual><collision name='v'>" + geometry + "</collision></link>")),
            kOneInfo);
  EXPECT_EQ(in_sdf("duplicate-sibling-name", sdf_of("<link name='l'/><frame name='l'/>")),
            kOneError);
}

TEST(Severity, OfXmlDeclarationsGoesByWhoReadsThem) {
  const std::string rest = "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>";
  EXPECT_EQ(in_sdf("xml-declaration-malformed", "<?xml version=\"0.0\"?>" + rest), kOneInfo);
  EXPECT_EQ(in_sdf("xml-declaration-malformed", "<?xml verison=\"1.0\"?>" + rest), kOneError);
  EXPECT_EQ(in_sdf("xml-declaration-not-first", "\n<?xml version=\"1.0\"?>" + rest), kOneWarning);
  EXPECT_EQ(in_sdf("xml-declaration-not-first", "<!-- a --><?xml version=\"1.0\"?>" + rest),
            kOneError);
}

TEST(Severity, OfSizesGoesByWhetherTheyCollide) {
  const std::string ball = "<geometry><sphere><radius>0</radius></sphere></geometry>";
  EXPECT_EQ(in_sdf("size-not-positive",
                   sdf_of("<link name='l'><visual name='v'>" + ball + "</visual></link>")),
            kOneWarning);
  EXPECT_EQ(in_sdf("size-not-positive",
                   sdf_of("<link name='l'><collision name='v'>" + ball + "</collision></link>")),
            kOneError);
}

TEST(Severity, OfTextBehindANumberIsSmallForZeros) {
  EXPECT_EQ(in_sdf("value-trailing-text", boxed("<mass>1</mass><pose>0 0 0 0 0 0</pose>")),
            kNothing);
  EXPECT_EQ(in_sdf("value-trailing-text", boxed("<mass>1kg</mass>")), kOneWarning);
  EXPECT_EQ(in_sdf("value-trailing-text", boxed("<mass>1g</mass>")), kOneError);
  const std::string camera =
      "<link name='l'><sensor name='s' type='camera'><camera><image><width>WIDTH</width>"
      "<height>480</height></image></camera></sensor></link>";
  const auto with_width = [&camera](const std::string& width) {
    std::string text = camera;
    return sdf_of(text.replace(text.find("WIDTH"), 5, width));
  };
  EXPECT_EQ(in_sdf("value-trailing-text", with_width("818.0")), kOneInfo);
  EXPECT_EQ(in_sdf("value-trailing-text", with_width("818.5")), kOneError);
}

TEST(Severity, OfNoEffortGoesByWhetherAnythingDrivesTheJoint) {
  const auto of_joint = [](const std::string& name, const std::string& beside) {
    return in_urdf("effort-zero",
                   "<robot name='r'><link name='a'/><link name='b'/><joint name='" + name +
                       "' type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
                       "<limit effort='0' velocity='1'/></joint>" +
                       beside + "</robot>");
  };
  const auto control = [](const std::string& interface) {
    return "<ros2_control name='c' type='system'><hardware><plugin>p/P</plugin></hardware><joint "
           "name='arm'><" +
           interface + " name='position'/></joint></ros2_control>";
  };
  const auto plugin = [](const std::string& file, const std::string& joints) {
    return "<gazebo><plugin name='n' filename='" + file + "'><joint_name>" + joints +
           "</joint_name></plugin></gazebo>";
  };
  EXPECT_EQ(of_joint("arm", ""), kOneInfo);
  EXPECT_EQ(of_joint("arm", control("command_interface")), kOneWarning);
  EXPECT_EQ(of_joint("arm", control("state_interface")), kOneInfo);
  EXPECT_EQ(of_joint("arm", plugin("libmotor.so", "leg, arm")), kOneWarning);
  EXPECT_EQ(of_joint("arm", plugin("libmotor.so", "forearm arm_2")), kOneInfo);
  EXPECT_EQ(of_joint("arm", plugin("gz-sim-joint-state-publisher-system", "arm")), kOneInfo);
  EXPECT_EQ(of_joint("caster_swivel_joint", ""), kNothing);
  EXPECT_EQ(of_joint("caster_swivel_joint", plugin("libmotor.so", "caster_swivel_joint")),
            kOneWarning);
}

TEST(Severity, OfNegativeEffortsGoesByWhetherOneMeansUnlimited) {
  const auto limited = [](const std::string& effort) {
    return "<sdf version='1.10'><model name='m'><link name='a'/><link name='b'/><joint name='j' "
           "type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz><limit>"
           "<lower>-1</lower><upper>1</upper><effort>" +
           effort + "</effort></limit></axis></joint></model></sdf>";
  };
  EXPECT_EQ(in_sdf("effort-limit-negative", limited("-1")), kOneInfo);
  EXPECT_EQ(in_sdf("effort-limit-negative", limited("-30")), kOneWarning);
}

TEST(Severity, OfSoftLimitsIsSmallWhereTheyMeanNone) {
  const auto safety = [](const char* lower, const char* upper) {
    return urdf_of(std::string("<safety_controller k_velocity='1' soft_lower_limit='") + lower +
                   "' soft_upper_limit='" + upper + "'/>");
  };
  EXPECT_EQ(in_urdf("safety-limits-outside", safety("-10", "10")), kOneInfo);
  EXPECT_EQ(in_urdf("safety-limits-outside", safety("-1.5", "1.5")), kOneWarning);
}

TEST(Severity, OfCentersOfMassGoesByDistance) {
  const std::string rest =
      "<mass>500</mass><inertia><ixx>83</ixx><iyy>83</iyy><izz>83</izz></inertia>";
  EXPECT_EQ(in_sdf("center-of-mass-outside-shapes", boxed("<pose>0.6 0 0 0 0 0</pose>" + rest)),
            kOneInfo);
  EXPECT_EQ(in_sdf("center-of-mass-outside-shapes", boxed("<pose>12 0 0 0 0 0</pose>" + rest)),
            kOneWarning);
}

TEST(Severity, OfAMirroredFingerIsAWarning) {
  EXPECT_EQ(
      in_sdf("center-of-mass-outside-shapes",
             sdf_of("<link name='finger'><inertial><pose>0 -0.03 0 0 0 0</pose><mass>0.1</mass>"
                    "<inertia><ixx>1e-5</ixx><iyy>1e-5</iyy><izz>1e-5</izz></inertia></inertial>"
                    "<collision name='c'><pose>0 0.03 0 0 0 0</pose><geometry><box>"
                    "<size>0.02 0.04 0.02</size></box></geometry></collision></link>")),
      kOneWarning);
}

TEST(Severity, OfMassRatiosGoesByTheRatio) {
  const auto pair = [](const char* mass) {
    const std::string body =
        "</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
    return sdf_of("<link name='a'><inertial><mass>" + std::string(mass) + body +
                  "</link><link name='b'><inertial><mass>0.001" + body +
                  "</link><joint name='j' type='revolute'><parent>a</parent><child>b</child>"
                  "<axis><xyz>0 0 1</xyz></axis></joint>");
  };
  EXPECT_EQ(in_sdf("mass-ratio-across-joint", pair("2")), kOneInfo);
  EXPECT_EQ(in_sdf("mass-ratio-across-joint", pair("2000")), kOneWarning);
}

TEST(Severity, OfAMimicOnAFixedJointIsSmall) {
  EXPECT_EQ(in_urdf("mimic-dof-mismatch",
                    "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>"
                    "<joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint>"
                    "<joint name='k' type='fixed'><parent link='a'/><child link='c'/>"
                    "<mimic joint='j'/></joint></robot>"),
            kOneInfo);
}

TEST(Severity, OfJointPropertiesIsAWarningSinceNoReaderHasThem) {
  EXPECT_EQ(in_urdf("deprecated-element", urdf_of("<joint_properties damping='1'/>")), kOneWarning);
}

TEST(Severity, OfARobotWithoutAnyMassIsAWarningOnce) {
  EXPECT_EQ(in_urdf("moving-link-massless", urdf_of("")), kOneWarning);
}

TEST(Severity, OfTensorsGoesByWhetherTheyAreZeroButForRounding) {
  const auto tensor = [](const std::string& ixx, const std::string& others) {
    return "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/><inertia "
           "ixx='" +
           ixx + "' iyy='" + others + "' izz='" + others +
           "' ixy='0' ixz='0' iyz='0'/></inertial></link>"
           "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint></robot>";
  };
  EXPECT_EQ(in_urdf("inertia-not-positive-definite", tensor("-1", "1")), kOneError);
}

TEST(Severity, OfTheIdentityGoesByHowFarItIsFromTheShapes) {
  const std::string tensor = "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>";
  EXPECT_EQ(in_sdf("inertia-identity", boxed("<mass>6</mass>" + tensor)), kNothing);
  EXPECT_EQ(in_sdf("inertia-identity", boxed("<mass>2</mass>" + tensor)), kOneInfo);
  EXPECT_EQ(in_sdf("inertia-identity", boxed("<mass>0.1</mass>" + tensor)), kOneWarning);
}

TEST(Severity, ThatTheUserSetsHoldsForAllFindings) {
  const std::string text = sdf_of(
      "<link name='l'><visual name='v'><geometry><sphere><radius>0</radius></sphere></geometry>"
      "</visual></link>");
  EXPECT_EQ(in_sdf("size-not-positive", text, {.set = Severity::kError}), kOneError);
  EXPECT_EQ(in_sdf("size-not-positive", text, {.set = Severity::kInfo}), kOneInfo);
}

Severities in_mjcf(const std::string& rule, const std::string& text) {
  return severities(rule, "a.xml", "<mujoco>" + text + "</mujoco>");
}

TEST(Severity, OfARangeWithoutEffectGoesByWhetherMujocoRejectsIt) {
  const auto joint = [](const std::string& limited) {
    return "<compiler autolimits='false'/><worldbody><body><joint range='-1 1' " + limited +
           "/><geom size='1'/></body></worldbody>";
  };
  EXPECT_EQ(in_mjcf("mjcf-range-ignored", joint("limited='false'")), kOneWarning);
  EXPECT_EQ(in_mjcf("mjcf-range-ignored", joint("")), kOneError);
  EXPECT_EQ(in_mjcf("mjcf-range-ignored", joint("limited='true'")), kNothing);
}

}  // namespace
}  // namespace rigor::rules
