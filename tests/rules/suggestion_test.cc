// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Suggestions of the rules that look at a robot as it stands assembled: one slip in a sane robot is found,
// and the fix that comes with the finding gives the robot back, byte for byte.

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/edit.h>

#include "support/corpus.h"

namespace rigor::rules {
namespace {

struct PlantedSlip {
  const char* base;
  const char* after;  ///< the slip is in the first such text behind this one
  const char* right;
  const char* wrong;
  const char* rule;
};

std::ostream& operator<<(std::ostream& out, const PlantedSlip& slip) {
  return out << slip.rule << ": " << slip.right << " -> " << slip.wrong;
}

class Suggestion : public testing::TestWithParam<PlantedSlip> {};

/// The bytes after the fix of the rule's only finding; nothing when there is none, or no fix.
std::optional<std::string> mended(const std::string& path, const std::string& bytes,
                                  const std::string& rule) {
  MemoryDisk disk;
  disk.put(path, bytes);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {path}}, sources);
  std::optional<std::string> after;
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule != rule) continue;
    EXPECT_FALSE(after) << "two findings";
    EXPECT_FALSE(found.fixes.empty()) << found.message;
    if (found.fixes.empty()) return std::nullopt;
    EXPECT_EQ(found.fixes.front().applicability, Applicability::kUnsafe);
    after = apply_edits(bytes, found.fixes.front().edits);
  }
  return after;
}

TEST_P(Suggestion, GivesTheRobotBack) {
  const PlantedSlip& slip = GetParam();
  const std::string sane = test::read_file(std::string(RIGOR_TESTDATA) + "sane/" + slip.base);
  std::string bytes = sane;
  const std::size_t behind = bytes.find(slip.after);
  ASSERT_NE(behind, std::string::npos);
  const std::size_t at = bytes.find(slip.right, behind);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, std::string(slip.right).size(), slip.wrong);
  const auto after = mended(slip.base, bytes, slip.rule);
  ASSERT_TRUE(after) << "not found";
  EXPECT_EQ(*after, sane);
  EXPECT_FALSE(mended(slip.base, sane, slip.rule));
}

constexpr PlantedSlip kSlips[] = {
    {"hauler.urdf", "front_left_axle", "0.2 0.22 -0.03", "200 220 -30", "link-misplaced"},
    {"hauler.urdf", "front_left_axle", "0.2 0.22 -0.03", "20 22 -3", "link-misplaced"},
    {"hauler.urdf", "lidar_mount", "0.2 0 0.1", "0.2 0 100", "link-misplaced"},
    {"rover.sdf", "<link name=\"caster\">", "-0.15 0 0.04", "-15 0 0.04", "link-misplaced"},
    {"walker.urdf", "\"neck\"", "0 0 0.36", "0 0 3.6", "link-misplaced"},
    {"walker.urdf", "1.2\"/>", "0 0 0.09", "0 0 90", "shape-misplaced"},
    {"hauler.urdf", "radius=\"0.04\" length=\"0.06\"/>\n      </geometry>\n      <material",
     "<collision>\n      <geometry>\n        <cylinder radius=\"0.04\"",
     "<collision>\n      <geometry>\n        <cylinder radius=\"0.08\"", "shape-size-slip"},
    {"hauler.urdf", "rear_right_axle", "-0.2 -0.22 -0.03", "-0.2 0.22 -0.03", "twins-in-one-place"},
    {"hauler.urdf", "rear_right_axle", "-0.2 -0.22 -0.03", "-0.2 -0.022 -0.03",
     "sibling-value-differs"},
    {"walker.urdf", "<link name=\"right_shin\">", "value=\"1.6\"", "value=\"16\"",
     "twin-value-differs"},
    {"quadruped.sdf", "<link name=\"rr_thigh\">", "0 -0.05 0", "0 0.05 0", "mirrored-sign-lost"},
};

INSTANTIATE_TEST_SUITE_P(OfAssembledRobots, Suggestion, testing::ValuesIn(kSlips));

}  // namespace
}  // namespace rigor::rules
