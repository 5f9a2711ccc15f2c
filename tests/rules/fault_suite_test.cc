// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks the models of testdata/faults, each with one planted fault, and those of testdata/sane, which
// have none. What is expected of each stands in suite.tsv; testdata/faults/README.md explains it.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/grouping.h>

#include "support/corpus.h"

namespace rigor::rules {
namespace {

namespace fs = std::filesystem;

const std::string kFaults = std::string(RIGOR_TESTDATA) + "faults/";
const std::string kSane = std::string(RIGOR_TESTDATA) + "sane/";
constexpr std::string_view kNone = "-";

struct PlantedFault {
  std::string file;
  std::string rule;
  std::string other;
  std::string base;
  std::string what;

  /// A rule without a file, and why.
  bool excuse() const { return file == kNone; }
};

std::vector<PlantedFault> read_faults() {
  std::istringstream lines(test::read_file(kFaults + "suite.tsv"));
  std::vector<PlantedFault> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream fields(line);
    PlantedFault row;
    for (std::string* field : {&row.file, &row.rule, &row.other, &row.base, &row.what}) {
      std::getline(fields, *field, '\t');
    }
    rows.push_back(row);
  }
  return rows;
}

struct Fired {
  std::map<std::string, std::string> rules;  ///< that find something, with what they say
  std::size_t loud = 0;                      ///< errors and warnings, one a cause
};

Fired rules_that_fire(const std::string& path) {
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {path}}, sources);
  EXPECT_TRUE(result.unusable.empty()) << path;
  Fired found;
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    found.rules.emplace(diagnostic.rule, diagnostic.message);
  }
  const Diagnostics groups = grouped(result.diagnostics);
  found.loud = groups.count(Severity::kError) + groups.count(Severity::kWarning);
  return found;
}

bool names_a_model(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".sdf" || ending == ".urdf" || ending == ".world" ||
         path.filename() == "model.config";
}

std::vector<std::string> models_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (names_a_model(entry.path())) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(FaultSuiteOfRules, EachFaultIsNamedByItsRuleAndByOneOtherAtMost) {
  constexpr double kMaxOfAFault = 1.15;  // errors and warnings, in the mean
  std::size_t faults = 0;
  std::size_t loud = 0;
  for (const PlantedFault& row : read_faults()) {
    if (row.excuse()) continue;
    std::set<std::string> expected{row.rule};
    if (row.other != kNone) expected.insert(row.other);
    const Fired fired = rules_that_fire(kFaults + row.file);
    const auto& found = fired.rules;
    faults += fired.loud > 0 ? 1U : 0U;
    loud += fired.loud;
    if (found.count("mesh-importer-missing") != 0) continue;  // assimp is not installed here
    std::set<std::string> rules;
    std::string said;
    for (const auto& [rule, message] : found) {
      rules.insert(rule);
      said += "\n  " + rule + ": " + message;
    }
    EXPECT_EQ(rules, expected) << row.file << " (" << row.what << ")" << said;
  }
  EXPECT_LE(static_cast<double>(loud), kMaxOfAFault * static_cast<double>(faults))
      << loud << " errors and warnings for " << faults << " faults";
}

TEST(FaultSuiteOfRules, IsAsLargeAsItClaims) {
  constexpr std::size_t kFewest = 250;
  std::size_t faults = 0;
  for (const PlantedFault& row : read_faults()) faults += row.excuse() ? 0U : 1U;
  EXPECT_GE(faults, kFewest);
}

TEST(FaultSuiteOfRules, HasARowForEachFileAndNoneTwice) {
  std::set<std::string> files;
  for (const PlantedFault& row : read_faults()) {
    EXPECT_FALSE(row.what.empty()) << row.file;
    if (row.excuse()) continue;
    EXPECT_TRUE(files.insert(row.file).second) << row.file << " has two rows";
    EXPECT_TRUE(fs::exists(kSane + row.base)) << row.base;
    EXPECT_NE(test::read_file(kFaults + row.file), test::read_file(kSane + row.base)) << row.file;
  }
  for (const std::string& path : models_below(kFaults)) {
    const std::string file = path.substr(kFaults.size());
    // A folder called as a rule's file would be holds all that belongs to that fault.
    const std::string folder = fs::path(file).parent_path().string() + "/";
    const auto first = files.lower_bound(folder);
    const bool neighbor = folder.find_first_of("0123456789") != std::string::npos &&
                          first != files.end() && first->starts_with(folder);
    EXPECT_TRUE(files.count(file) != 0 || neighbor) << file << " has no row";
  }
}

TEST(FaultSuiteOfRules, CoversEachRuleThatIsOnByDefault) {
  std::set<std::string> covered;
  std::set<std::string> excused;
  for (const PlantedFault& row : read_faults()) (row.excuse() ? excused : covered).insert(row.rule);
  const Registry registry;
  for (const Rule& rule : registry.rules()) {
    const std::string name(rule.name);
    const bool elsewhere =
        rule.category == Category::kConvert || rule.category == Category::kSimulate ||
        rule.category == Category::kSuppression || rule.category == Category::kXacro;
    if (elsewhere || !(rule.targets == Targets{})) continue;
    EXPECT_NE(covered.count(name), excused.count(name))
        << name << " needs a row in testdata/faults/suite.tsv, of a fault or of the reason why not";
    covered.erase(name);
    excused.erase(name);
  }
  for (const std::string& name : excused) ADD_FAILURE() << name << " is no rule of those";
}

TEST(SaneModels, HaveNoErrorAndNoWarning) {
  constexpr std::size_t kFewest = 10;
  const std::vector<std::string> paths = models_below(kSane);
  EXPECT_GE(paths.size(), kFewest);
  for (const std::string& path : paths) {
    const Fired fired = rules_that_fire(path);
    for (const auto& [rule, message] : fired.rules) {
      ADD_FAILURE() << path << "\n  " << rule << ": " << message;
    }
  }
}

}  // namespace
}  // namespace rigor::rules
