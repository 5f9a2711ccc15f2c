// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Faults planted in the templates of testdata/xacro/faults/base, one at a time: a text of a file becomes
// another. Each is found once, by its rule, at the line that was changed or with that line beside it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor::rules {
namespace {

const std::string kPlantedFolder = std::string(RIGOR_TESTDATA) + "xacro/faults/";
constexpr const char* kTemplates[] = {"robot.urdf.xacro", "leg.xacro", "shapes.xacro",
                                      "limits.yaml"};

struct TemplateFault {
  std::string file, from, to, rule, consequences;
};

std::vector<TemplateFault> template_faults() {
  std::istringstream lines(test::read_file(kPlantedFolder + "suite.tsv"));
  std::vector<TemplateFault> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    TemplateFault& row = rows.emplace_back();
    for (std::string* field : {&row.file, &row.from, &row.to, &row.rule, &row.consequences})
      std::getline(fields, *field, '\t');
  }
  return rows;
}

MemoryDisk templates_with(const TemplateFault& fault, std::uint32_t& line) {
  MemoryDisk disk;
  for (const std::string file : kTemplates) {
    std::string text = test::read_file(kPlantedFolder + "base/" + file);
    if (file == fault.file) {
      const std::size_t at = text.find(fault.from);
      EXPECT_NE(at, std::string::npos) << fault.from;
      line = static_cast<std::uint32_t>(
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      text.replace(at, fault.from.size(), fault.to);
    }
    disk.put(file, text);
  }
  return disk;
}

/// Empty when the fault is found as it should be.
std::string missed(const TemplateFault& fault) {
  std::uint32_t line = 0;
  const MemoryDisk disk = templates_with(fault, line);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"robot.urdf.xacro"}}, sources);
  const auto is_there = [&](Span where) {
    return !where.nowhere() && sources.path(where.source) == fault.file &&
           sources.position(where.source, where.begin).line == line;
  };
  std::string said;
  std::size_t own = 0;
  bool is_placed = false;
  bool others = false;
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.severity == Severity::kInfo) continue;
    said += "\n  " + std::string(found.rule) + ": " + found.message;
    if (found.rule != fault.rule) {
      others = others || fault.consequences.find(found.rule) == std::string::npos;
      continue;
    }
    ++own;
    is_placed = is_placed || is_there(found.where) ||
                std::any_of(found.related.begin(), found.related.end(),
                            [&](const Label& label) { return is_there(label.where); });
  }
  if (own == 1 && is_placed && !others) return {};
  return fault.file + ':' + std::to_string(line) + ": " + fault.to + said;
}

TEST(PlantedTemplateFaults, AreFoundOnceWhereTheyWerePlanted) {
  const std::vector<TemplateFault> faults = template_faults();
  ASSERT_GE(faults.size(), 60U);
  std::size_t found = 0;
  std::string all_missed;
  for (const TemplateFault& fault : faults) {
    const std::string why = missed(fault);
    if (why.empty()) ++found;
    if (!why.empty()) all_missed += why + '\n';
  }
  std::printf("%zu of %zu faults\n", found, faults.size());
  EXPECT_GE(static_cast<double>(found), 0.95 * static_cast<double>(faults.size())) << all_missed;
}

TEST(PlantedTemplateFaults, AreNotInTheBase) {
  std::uint32_t line = 0;
  const MemoryDisk disk = templates_with({}, line);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"robot.urdf.xacro"}}, sources);
  EXPECT_TRUE(result.diagnostics.list().empty());
}

}  // namespace
}  // namespace rigor::rules
