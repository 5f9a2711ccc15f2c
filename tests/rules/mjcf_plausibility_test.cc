// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What MuJoCo takes and nobody means, and what looks like it and is meant.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>

namespace rigor::rules {
namespace {

using Found = std::vector<std::string>;

/// Messages of the rule.
Found found(const std::string& rule, const std::string& text) {
  const MemoryDisk disk({{"a.xml", "<mujoco>" + text + "</mujoco>"}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.xml"}}, sources);
  Found messages;
  for (const Diagnostic& each : result.diagnostics.list()) {
    if (each.rule == rule) messages.push_back(each.message);
    if (each.rule == rule && !each.rule.starts_with("mjcf-")) {
      EXPECT_TRUE(each.fixes.empty()) << "of another format: " << rule;
    }
  }
  return messages;
}

std::string jointed(const std::string& joint, const std::string& compiler = {}) {
  return compiler + "<worldbody><body><joint " + joint + "/><geom size='.1'/></body></worldbody>";
}

TEST(MjcfPlausibility, DegreesWhereRadiansAreRead) {
  const auto range = [](const std::string& numbers) {
    return found("mjcf-angle-looks-like-degrees",
                 jointed("range='" + numbers + "'", "<compiler angle='radian'/>"))
        .size();
  };
  EXPECT_EQ(range("-90 90"), 1U);
  EXPECT_EQ(range("0 170"), 1U);
  EXPECT_EQ(range("-3.14 3.14"), 0U);
  EXPECT_EQ(range("-6.28319 6.28319"), 0U);
  EXPECT_EQ(range("-100 100"), 0U);  // a winch
  EXPECT_EQ(range("-1e6 1e6"), 0U);  // no limit
  EXPECT_EQ(found("mjcf-angle-looks-like-degrees", jointed("range='-90 90'")), Found{});
  EXPECT_EQ(
      found("mjcf-angle-looks-like-degrees",
            "<compiler angle='radian'/><worldbody><geom size='1' euler='0 0 90'/></worldbody>"),
      Found{"euler 0 0 90 looks like degrees and is read in radians"});
}

TEST(MjcfPlausibility, GravityPointsDownAndIsThatOfAPlanet) {
  const auto gravity = [](const std::string& numbers) {
    return found("mjcf-gravity-suspicious", "<option gravity='" + numbers + "'/>").size();
  };
  EXPECT_EQ(gravity("0 0 9.81"), 1U);
  EXPECT_EQ(gravity("0 -9.81 0"), 1U);
  EXPECT_EQ(gravity("0 0 -981"), 1U);
  EXPECT_EQ(gravity("0 0 -1.62"), 0U);
  EXPECT_EQ(gravity("0 0 0"), 0U);
}

TEST(MjcfPlausibility, AGeomWithBitsOfItsOwnTouchesNothing) {
  const auto alone = [](const std::string& others) {
    return found("mjcf-geom-never-touches",
                 "<worldbody><geom size='1'/><body><freejoint/><geom size='1' contype='2' "
                 "conaffinity='2'/></body>" +
                     others + "</worldbody>")
        .size();
  };
  EXPECT_EQ(alone(""), 1U);
  EXPECT_EQ(alone("<geom size='1' contype='2' conaffinity='0'/>"), 0U);
}

TEST(MjcfPlausibility, AKeyframeIsWithinTheRanges) {
  const auto at = [](const std::string& qpos) {
    return found("mjcf-keyframe-implausible",
                 "<worldbody><body><body><joint name='late' range='-10 10'/><geom size='1'/></body>"
                 "<joint name='early' type='slide' range='0 1'/><geom size='1'/></body>"
                 "<body><joint type='ball'/><geom size='1'/></body></worldbody>"
                 "<keyframe><key qpos='" +
                     qpos + "'/></keyframe>");
  };
  // The joint of the outer body comes first, though it is written after the inner body.
  EXPECT_EQ(at("0.5 0.1 1 0 0 0"), Found{});
  EXPECT_EQ(at("2 0.1 1 0 0 0"), Found{"joint 'early' is at 2, outside its range 0 to 1"});
  EXPECT_EQ(at("0.5 1 1 0 0 0").size(), 1U);
  EXPECT_EQ(at("0.5 0.1 0 0 0 0"), Found{"the quaternion of a joint is zero"});
}

TEST(MjcfPlausibility, SolverParametersAreThoseThatAreWritten) {
  const auto solref = [](const std::string& attribute) {
    return found("mjcf-solver-parameters",
                 "<worldbody><geom size='1' " + attribute + "/></worldbody>")
        .size();
  };
  EXPECT_EQ(solref("solref='-100 1'"), 1U);
  EXPECT_EQ(solref("solref='-100 -1'"), 0U);
  EXPECT_EQ(solref("solref='0.001 1'"), 1U);
  EXPECT_EQ(solref("solref='0.004 1'"), 0U);
  EXPECT_EQ(solref("solimp='0.9 0.5'"), 1U);
  EXPECT_EQ(solref("solimp='0.9 1.5'"), 1U);
  EXPECT_EQ(solref("solimp='0.5'"), 0U);
}

TEST(MjcfPlausibility, WhatAClassGivesIsOneMistake) {
  EXPECT_EQ(found("mjcf-value-negative",
                  "<default><joint damping='-1'/></default>" + jointed("/><joint axis='1 0 0'"))
                .size(),
            1U);
  EXPECT_EQ(found("mjcf-value-negative",
                  jointed("name='j'") + "<actuator><position joint='j' kp='-5'/></actuator>"),
            Found{"kp is negative: -5"});
}

TEST(MjcfPlausibility, RulesOnModelsRun) {
  const auto body = [](const std::string& inertial) {
    return "<worldbody><body><freejoint/><inertial " + inertial +
           "/><geom type='box' size='.1 .1 .1'/></body></worldbody>";
  };
  const std::string sane = "pos='0 0 0' mass='2' diaginertia='.015 .015 .015'";
  const std::string heavy = "pos='0 0 0' mass='2000' diaginertia='.015 .015 .015'";
  EXPECT_EQ(found("inertia-density-impossible", body(sane)), Found{});
  EXPECT_EQ(found("inertia-density-impossible", body(heavy)).size(), 1U);
  EXPECT_EQ(found("inertia-geometry-mismatch", body("pos='0 0 0' mass='2' diaginertia='15 15 15'"))
                .size(),
            1U);
  EXPECT_EQ(found("center-of-mass-outside-shapes",
                  body("pos='0 0 150' mass='2' diaginertia='.015 .015 .015'"))
                .size(),
            1U);
}

TEST(MjcfPlausibility, ASpaceAroundANameIsNamed) {
  EXPECT_EQ(found("mjcf-reference-missing",
                  jointed("name='j'") + "<actuator><motor joint=' j'/></actuator>"),
            Found{"joint ' j' does not exist: there is a space before the name"});
  EXPECT_EQ(found("mjcf-keyword-unknown", jointed("type='hinge '")),
            Found{"'hinge ' is not a value of type: there is a space after the name"});
}

/// A list of all names for each that is missing would fill the memory.
TEST(MjcfPlausibility, ManyMissingNamesAreCheap) {
  std::string bodies, pairs;
  for (int i = 0; i < 20'000; ++i) {
    bodies += "<body name='b" + std::to_string(i) + "'/>";
    pairs += "<exclude body1='x" + std::to_string(i) + "' body2='b0'/>";
  }
  EXPECT_FALSE(found("mjcf-reference-missing",
                     "<worldbody>" + bodies + "</worldbody><contact>" + pairs + "</contact>")
                   .empty());
}

}  // namespace
}  // namespace rigor::rules
