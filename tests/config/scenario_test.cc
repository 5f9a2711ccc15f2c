// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/scenario.h>

#include <gtest/gtest.h>

#include <string>

#include "support/corpus.h"

namespace rigor::config {
namespace {

constexpr const char* kWhole = R"(schema = 1
model = "robot.sdf"
[world]
gravity = [0, 0, -1.6]
ground = {mu = 0.4}
[run]
time-step = 0.002
solver = "dantzig"
seeds = 3
[spawn]
on-ground = true
[joints]
left = "left_wheel_hinge"
[[step]]
name = "settle"
until = 1
[[step]]
until = 5.0
commands = [{joint = ["left", "right_wheel_hinge"], velocity = 10, ramp = 1.5},
            {joint = "arm", position = -0.5, gains = [100, 1, 10], max-effort = 20, axis = 1}]
pushes = [{link = "chassis", impulse = [0.5, 0, 0], point = [0, 0, 0.1], at = 2}]
tilt = {angle = 0.3, axis = [1, 0, 0]}
[[assert]]
name = "straight"
metric = "drive.lateral"
max = 0.005
[[assert]]
orientation = "chassis"
axis = "pitch"
at = 4
min = -0.1
[[assert]]
joint = "left"
min = 30
max = 40
)";

TEST(Scenario, IsReadAsItsAuthorWroteIt) {
  const ScenarioFile file = read_scenario("drive.toml", kWhole);
  for (const Problem& problem : file.problems)
    ADD_FAILURE() << problem.line << ' ' << problem.message;
  EXPECT_EQ(file.model, "robot.sdf");
  EXPECT_EQ(file.gravity, (Numbers3{0, 0, -1.6}));
  EXPECT_EQ(file.ground_mu, 0.4);
  EXPECT_EQ(file.time_step, 0.002);
  EXPECT_EQ(file.solver, "dantzig");
  EXPECT_EQ(file.seeds, 3U);
  EXPECT_TRUE(file.on_ground);
  ASSERT_EQ(file.steps.size(), 2U);
  EXPECT_EQ(file.steps[0].name, "settle");
  EXPECT_EQ(file.steps[1].name, "step 2");
  EXPECT_EQ(file.steps[1].until, 5);
  ASSERT_EQ(file.steps[1].commands.size(), 2U);
  const ScenarioCommand& wheels = file.steps[1].commands[0];
  EXPECT_EQ(wheels.joints, (std::vector<std::string>{"left_wheel_hinge", "right_wheel_hinge"}));
  EXPECT_EQ(wheels.kind, CommandKind::kVelocity);
  EXPECT_EQ(wheels.value, 10);
  EXPECT_EQ(wheels.ramp, 1.5);
  const ScenarioCommand& arm = file.steps[1].commands[1];
  EXPECT_EQ(arm.kind, CommandKind::kPosition);
  EXPECT_EQ(arm.value, -0.5);
  EXPECT_EQ(arm.gains, (Numbers3{100, 1, 10}));
  EXPECT_EQ(arm.effort, 20);
  EXPECT_EQ(arm.axis, 1U);
  ASSERT_EQ(file.steps[1].pushes.size(), 1U);
  EXPECT_EQ(file.steps[1].pushes[0].point, (Numbers3{0, 0, 0.1}));
  ASSERT_TRUE(file.steps[1].tilt);
  EXPECT_EQ(file.steps[1].tilt->axis, (Numbers3{1, 0, 0}));
  ASSERT_EQ(file.asserts.size(), 3U);
  EXPECT_EQ(file.asserts[0].of, ScenarioAssert::Of::kMetric);
  EXPECT_EQ(file.asserts[1].of, ScenarioAssert::Of::kOrientation);
  EXPECT_EQ(file.asserts[1].axis, 1U);
  EXPECT_FALSE(file.asserts[1].max);
  EXPECT_EQ(file.asserts[2].of, ScenarioAssert::Of::kJointPosition);
  EXPECT_EQ(file.asserts[2].name_of, "left_wheel_hinge");
}

struct Bad {
  const char* text;
  unsigned line;
  const char* says;
};

class BadScenario : public testing::TestWithParam<Bad> {};

TEST_P(BadScenario, IsToldWithItsLine) {
  const ScenarioFile file = read_scenario("a.toml", GetParam().text);
  ASSERT_FALSE(file.problems.empty());
  EXPECT_EQ(file.problems.front().line, GetParam().line);
  EXPECT_NE(file.problems.front().message.find(GetParam().says), std::string::npos)
      << file.problems.front().message;
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadScenario,
    testing::Values(
        Bad{"[[step]]\nuntil = 1\nunitl = 2\n", 3, "unknown key unitl (known: name, until"},
        Bad{"[[step]]\nname = \"a\"\n", 1, "until is missing"},
        Bad{"[[step]]\nuntil = \"1\"\n", 2, "until must be a finite number"},
        Bad{"[[step]]\nuntil = nan\n", 2, "until must be a finite number"},
        Bad{"[[step]]\nuntil = 1\n[[step]]\nuntil = 1\n", 3, "later than the step before"},
        Bad{"model = \"a\"\n", 1, "at least one [[step]]"},
        Bad{"schema = 2\n[[step]]\nuntil = 1\n", 1, "schema must be 1"},
        Bad{"[run]\nsolver = \"bullet\"\n[[step]]\nuntil = 1\n", 1,
            "solver must be quick or dantzig"},
        Bad{"[world]\nground = 3\n[[step]]\nuntil = 1\n", 2, "ground must be true, false or"},
        Bad{"[[step]]\nuntil = 1\ncommands = [{joint = \"a\"}]\n", 3, "one of effort, velocity"},
        Bad{"[[step]]\nuntil = 1\ncommands = [{joint = \"a\", effort = 1, velocity = 2}]\n", 3,
            "one of effort, velocity"},
        Bad{"[[step]]\nuntil = 1\npushes = [{link = \"a\", impulse = [1, 2]}]\n", 3,
            "impulse must be three"},
        Bad{"[[step]]\nuntil = 1\n[[assert]]\nmetric = \"tilt.max\"\n", 3, "min or max"},
        Bad{"[[step]]\nuntil = 1\n[[assert]]\nposition = \"a\"\naxis = \"yaw\"\nmax = 1\n", 3,
            "x, y or z"},
        Bad{"[[step]\n", 1, ""}));

/// The example of the page is read without a problem, and has what the page says of it.
TEST(Scenario, ThatOfTheDocsIsRead) {
  const std::string page = test::read_file(std::string(RIGOR_SOURCE_DIR) + "/docs/scenarios.md");
  const std::string fence = "```toml\n";
  const std::size_t begin = page.find(fence) + fence.size();
  const ScenarioFile file =
      read_scenario("a.toml", page.substr(begin, page.find("```", begin) - begin));
  for (const Problem& problem : file.problems)
    ADD_FAILURE() << problem.line << ": " << problem.message;
  EXPECT_EQ(file.steps.size(), 3U);
  EXPECT_EQ(file.asserts.size(), 3U);
}

}  // namespace
}  // namespace rigor::config
