// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--compat sdformat` against what libsdformat 12.3 said of the same bytes: rules' examples, the planted
// faults, and cases of our own. testdata/compat/README.md explains the tables.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/example.h>
#include <rigor/rules/sdformat_inertia.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor::rules {
namespace {

std::vector<std::vector<std::string>> verdict_table(const std::string& name) {
  std::istringstream lines(test::read_file(std::string(RIGOR_TESTDATA) + "compat/" + name));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> row;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');) row.push_back(field);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The rules that find errors in a file, as libsdformat would judge; empty when it is taken.
std::string refused_for(const Disk& disk, const std::string& path, Compat compat) {
  const Environment environment(disk, {});
  Sources sources;
  ValidateOptions options{.paths = {path}, .meshes = MeshPolicy::kDoNotOpen};
  options.selection.compat = compat;
  std::set<std::string> rules;
  const ValidateResult result = validate(environment, options, sources);
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.severity == Severity::kError) rules.emplace(found.rule);
  }
  std::string joined;
  for (const std::string& rule : rules) joined += (joined.empty() ? "" : ", ") + rule;
  return joined;
}

/// 64-bit FNV-1a of an example's text: a verdict is of these bytes.
std::string example_hash(std::string_view text) {
  std::uint64_t value = 14695981039346656037U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 1099511628211U;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016lx", static_cast<unsigned long>(value));
  return digits;
}

std::string unescaped_case(const std::string& text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      bytes += text[i];
    } else {
      ++i;
      bytes += text[i] == 'n' ? '\n' : text[i];
    }
  }
  return bytes;
}

TEST(CompatSdformat, JudgesTheExamplesOfTheRules) {
  std::map<std::string, std::string> verdicts;
  for (const auto& row : verdict_table("examples.tsv")) verdicts[row[0]] = row[1];
  const Registry registry;
  int known = 0;
  int all = 0;
  for (const Rule& rule : registry.rules()) {
    // The checker is not asked about these.
    if (rule.category == Category::kConvert || rule.category == Category::kSimulate) continue;
    if (rule.formats == Formats::kMjcf) continue;
    const Examples examples = examples_of(rule);
    for (const auto* kind : {&examples.bad, &examples.good}) {
      for (const Example& example : *kind) {
        const ParsedExample parsed = parse_example(example.text);
        const std::string path = example_path(parsed.files.front());
        // The checker is not asked about these.
        if (path.ends_with("model.config") || path.ends_with(".xacro")) continue;
        ++all;
        const auto verdict = verdicts.find(example_hash(example.text));
        if (verdict == verdicts.end()) continue;
        ++known;
        MemoryDisk disk;
        for (const ParsedExample::File& file : parsed.files)
          disk.put(example_path(file), file.bytes);
        const std::string why = refused_for(disk, path, Compat::kSdformat);
        EXPECT_EQ(why.empty() ? "valid" : "invalid", verdict->second)
            << rule.name << ": " << why << '\n'
            << example.text;
      }
    }
  }
  std::printf("%d of %d examples have a verdict\n", known, all);
  EXPECT_GE(known, 0.9 * all)
      << "examples changed: run the checker over them, see the README there";
}

TEST(CompatSdformat, JudgesThePlantedFaults) {
  int judged = 0;
  for (const auto& row : verdict_table("faults.tsv")) {
    const RealDisk disk;
    const std::string path = std::string(RIGOR_TESTDATA) + row[0];
    const std::string why = refused_for(disk, path, Compat::kSdformat);
    EXPECT_EQ(why.empty() ? "valid" : "invalid", row[1]) << row[0] << ": " << why;
    ++judged;
  }
  EXPECT_GE(judged, 530);
}

TEST(CompatSdformat, JudgesTheCases) {
  int judged = 0;
  int different = 0;
  for (const auto& row : verdict_table("cases.tsv")) {
    MemoryDisk disk;
    disk.put(row[0], unescaped_case(row[3]));
    const std::string why = refused_for(disk, row[0], Compat::kSdformat);
    ++judged;
    if (row[2] != "-") {  // docs/compat.md says so
      ++different;
      continue;
    }
    EXPECT_EQ(why.empty() ? "valid" : "invalid", row[1]) << row[0] << ": " << why << '\n' << row[3];
  }
  EXPECT_GE(judged, 1030);
  EXPECT_LE(different, 16);
}

TEST(CompatSdformat, RulesAboutTheCheckerAloneAreSilentWithoutIt) {
  MemoryDisk disk;
  disk.put("r.urdf", "<robot name='r'><link name='a'/></robot>");
  EXPECT_EQ(refused_for(disk, "r.urdf", Compat::kNone), "");
  EXPECT_EQ(refused_for(disk, "r.urdf", Compat::kSdformat), "no-link-left-in-sdf");
}

TEST(CompatSdformat, AnOverrideGoesBeforeIt) {
  MemoryDisk disk;
  disk.put("a.sdf", "<sdf version='1.9'><model name='m'><static>1</static></model><oops/></sdf>");
  const Environment environment(disk, {});
  Sources sources;
  ValidateOptions options{.paths = {"a.sdf"}};
  options.selection.compat = Compat::kSdformat;
  EXPECT_EQ(validate(environment, options, sources).diagnostics.count(Severity::kError), 0U);
  options.selection.severity = {{"unknown-element", Severity::kError}};
  EXPECT_EQ(validate(environment, options, sources).diagnostics.count(Severity::kError), 1U);
}

// Moments at the edge, as MassMatrix3d::IsValid of Ignition Math 6.10 judges them.
TEST(SdformatInertia, AllowsTenRoundings) {
  EXPECT_TRUE(sdformat_takes(1, {1, 0, 0, 0.999999999999999, 0, 2}));
  EXPECT_FALSE(sdformat_takes(1, {1, 0, 0, 0.99999999999999, 0, 2}));
  EXPECT_TRUE(sdformat_takes(1, {0, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(sdformat_takes(1, {0, 0, 0, 0, 0, 1}));
  EXPECT_FALSE(sdformat_takes(-1, {1, 0, 0, 1, 0, 1}));
  EXPECT_TRUE(sdformat_takes(1, {1, 0.5, 0, 1, 0, 1}));   // moments 0.5, 1, 1.5
  EXPECT_FALSE(sdformat_takes(1, {1, 0.6, 0, 1, 0, 1}));  // moments 0.4, 1, 1.6
}

}  // namespace
}  // namespace rigor::rules
