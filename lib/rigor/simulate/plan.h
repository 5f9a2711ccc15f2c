// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a user wants done, in the user's words: names of tests, joints and links, as the command line or a
// scenario file has them. `scenarios_of` finds what the names mean in a scene.
//
//   Plan plan{.tests = {"settle", "drive"}};
//   Planned planned = scenarios_of(plan, scene, wheels);
//   if (!planned.problems.empty()) ask_again(planned.problems);

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/config/scenario.h>
#include <rigor/simulate/fact.h>
#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// How models are kept up that nothing holds; kAuto as mount.h chooses, test by test.
enum class BaseOption : std::uint8_t { kAuto, kFixed, kFree, kHang };

struct Plan {
  std::vector<std::string> tests;  ///< of kTestNames
  std::vector<config::ScenarioFile> scenarios;
  std::vector<std::string> wheels;  ///< joints that are; found when empty
  BaseOption base = BaseOption::kAuto;
};

/// A name that is nothing in the scene.
struct PlanProblem {
  std::string what;  ///< "joint left_whel"
  std::string name;
  std::vector<std::string> candidates;
};

struct Planned {
  std::vector<Scenario> scenarios;
  std::vector<std::string> left_out;  ///< tests that make no sense for the scene, and why
  std::vector<std::string> notes;  ///< what was chosen for the user: of whose base is held, and why
  Facts facts;  ///< what of these is to be a finding: a base that is held though nothing says so
  std::vector<PlanProblem> problems;  ///< the invocation is wrong
};

Planned scenarios_of(const Plan& plan, const Scene& scene, const DriveTrain& wheels);

}  // namespace rigor::simulate
