// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether the suite is what its README says, before anything is simulated.

#include "simulate/fault_suite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include <rigor/mass/link_body.h>
#include <rigor/mass/resolve.h>
#include <rigor/rules/validate.h>
#include <rigor/simulate/test/tests.h>

namespace rigor {
namespace {

using test::SuiteCase;

std::set<std::string> suite_files_in(const std::string& folder) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(test::kSuiteFolder + folder)) {
    files.insert(folder + "/" + entry.path().filename().string());
  }
  return files;
}

TEST(FaultSuiteFiles, AreAllInTheTableAndLargeEnough) {
  std::set<std::string> sane;
  std::set<std::string> faults;
  for (const SuiteCase& row : test::suite_cases()) {
    EXPECT_NE(std::find(simulate::kTestNames.begin(), simulate::kTestNames.end(), row.test),
              simulate::kTestNames.end())
        << row.file << ": " << row.test;
    if (row.sane()) {
      sane.insert(row.file);
      continue;
    }
    EXPECT_TRUE(faults.insert(row.file).second) << row.file << " stands twice";
    EXPECT_FALSE(row.planted.empty()) << row.file;
    EXPECT_TRUE(row.expected == "warn" || row.expected == "solver" || row.expected == "fail" ||
                row.expected == "invalid")
        << row.file << ": " << row.expected;
  }
  EXPECT_EQ(sane, suite_files_in("sane"));
  EXPECT_EQ(faults, suite_files_in("faults"));
  EXPECT_GE(sane.size(), 15U);
  EXPECT_GE(faults.size(), 40U);
}

TEST(FaultSuiteFiles, SaneModelsHaveNoFinding) {
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const auto result =
      rules::validate(environment, {.paths = {test::kSuiteFolder + "sane"}}, sources);
  EXPECT_EQ(result.files.size(), suite_files_in("sane").size());
  for (const Diagnostic& finding : result.diagnostics.list()) {
    EXPECT_EQ(finding.severity, Severity::kInfo) << finding.rule << ": " << finding.message;
  }
}

/// The files' numbers were worked out apart from rigor, by hand-written closed forms and Steiner's theorem.
TEST(FaultSuiteFiles, SaneModelsHaveTheInertiasOfTheirShapes) {
  constexpr double kWrittenDigits = 1e-8;  // the files have ten digits, poses of them included
  std::size_t held = 0;
  for (const std::string& file : suite_files_in("sane")) {
    test::SuiteModel model(file);
    for (std::uint32_t i = 0; i < model.root().links.size(); ++i) {
      const model::Id<model::Link> id{i};
      const model::Link& link = model.root()[id];
      if (model::is_static(model.root(), link.model) || !link.inertial.written) continue;
      const auto body = mass::link_body(model.root(), model.input().frames, id,
                                        mass::From::kCollisions, model.input().find_mesh);
      ASSERT_TRUE(body.complete()) << file << ": " << link.name.value;
      const auto written =
          mass::resolve(model.root(), model.input().frames, id, model.input().find_mesh).body;
      const auto exact = mass::with_mass(mass::of_own_densities(body), written.mass);
      const double scale = exact.about_com.ixx + exact.about_com.iyy + exact.about_com.izz;
      EXPECT_NEAR(written.com.x, exact.com.x, kWrittenDigits) << file << ": " << link.name.value;
      EXPECT_NEAR(written.com.y, exact.com.y, kWrittenDigits) << file << ": " << link.name.value;
      EXPECT_NEAR(written.com.z, exact.com.z, kWrittenDigits) << file << ": " << link.name.value;
      const auto near = [&](double a, double b) {
        EXPECT_NEAR(a, b, kWrittenDigits * scale) << file << ": " << link.name.value;
      };
      near(written.about_com.ixx, exact.about_com.ixx);
      near(written.about_com.iyy, exact.about_com.iyy);
      near(written.about_com.izz, exact.about_com.izz);
      near(written.about_com.ixy, exact.about_com.ixy);
      near(written.about_com.ixz, exact.about_com.ixz);
      near(written.about_com.iyz, exact.about_com.iyz);
      ++held;
    }
  }
  EXPECT_GE(held, 60U);
}

}  // namespace
}  // namespace rigor
