// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Densities that mass and moments give, against balls and boxes whose density is known.

#include <rigor/rules/inertia/moment_slips.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

/// What inertia-density-impossible says of one moving link.
std::vector<Diagnostic> density_findings(double mass, double ixx, double iyy, double izz) {
  const std::string text = fmt::format(
      "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='{}'/><inertia "
      "ixx='{}' ixy='0' ixz='0' iyy='{}' iyz='0' izz='{}'/></inertial></link><joint name='j' "
      "type='continuous'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint></robot>",
      mass, ixx, iyy, izz);
  const MemoryDisk disk(std::map<std::string, std::string>{{"a.urdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  std::vector<Diagnostic> found;
  const ValidateResult result = validate(environment, {.paths = {"a.urdf"}}, sources);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == "inertia-density-impossible") found.push_back(diagnostic);
  }
  return found;
}

std::vector<Diagnostic> density_findings_of_ball(double mass, double density) {
  const double radius = std::cbrt(3 * mass / (4 * 3.14159265358979323846 * density));
  const double moment = 0.4 * mass * radius * radius;
  return density_findings(mass, moment, moment, moment);
}

TEST(MomentSlips, ABallDenserThanOsmiumIsNone) {
  EXPECT_TRUE(density_findings_of_ball(3, 22'590).empty());
  EXPECT_EQ(density_findings_of_ball(3, 26'000).size(), 1U);
}

TEST(MomentSlips, ABoxLighterThanAirIsNone) {
  // 2 × 1 × 1 m of 0.08 kg/m³ and 0.12 kg/m³, and of 8 g, which may be a token.
  const auto box = [](double mass) {
    return density_findings(mass, mass / 12 * 2, mass / 12 * 5, mass / 12 * 5);
  };
  ASSERT_EQ(box(0.16).size(), 1U);
  EXPECT_EQ(box(0.16).front().severity, Severity::kWarning);
  EXPECT_TRUE(box(0.24).empty());
  ASSERT_EQ(box(0.008).size(), 1U);
  EXPECT_EQ(box(0.008).front().severity, Severity::kInfo);
}

TEST(MomentSlips, AnAntennaIsDenseHoweverFarItReaches) {
  // A rod of 6 m and 5 mm.
  const double mass = 0.3;
  const double across = mass * 36 / 12;
  EXPECT_TRUE(density_findings(mass, across, across, mass * 0.0025 * 0.0025 / 2).empty());
}

TEST(MomentSlips, TheOneUnitThatFitsIsUndone) {
  // A cube of 10 cm and 1 kg in kg·mm².
  const double moment = 1e6 / 6 * 0.01;
  const auto found = density_findings(1, moment, moment, moment);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_FALSE(found.front().fixes.empty());
  // At the fifteen digits that are kept of a computed number.
  EXPECT_NEAR(std::stod(found.front().fixes.front().edits.front().text), moment / 1e6, 1e-17);
}

TEST(MomentSlips, ShareAndDensityTellMassAndMomentsApart) {
  const MomentSlip* moments = slip_of_share(1100, 900);
  ASSERT_NE(moments, nullptr);
  EXPECT_EQ(moments->moments, 1e-3);
  const MomentSlip* mass = slip_of_share(1e-3, 9e5);
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->mass, 1e-3);
  EXPECT_EQ(slip_of_share(30, 900), nullptr);
}

TEST(MomentSlips, PowersOfTenKeepDigits) {
  EXPECT_EQ(times_power_of_ten(411.07, 1e-6), "0.00041107");
  EXPECT_EQ(times_power_of_ten(3.368e-09, 1e3), "3.368e-06");
}

}  // namespace
}  // namespace rigor::rules
