// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--compat sdformat` over the corpus, held against what `ign sdf -k` of libsdformat 12.3 says of each file.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<std::string>> compat_table(const fs::path& path) {
  std::istringstream lines(test::read_file(path));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> row;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');) row.push_back(field);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The folders that the checker's run had for a set, in its order.
read::SearchPaths compat_paths(const std::string& set) {
  std::vector<std::string> folders{set};
  for (const auto& row : compat_table(fs::path(test::corpus()) / "../oracle/model-paths.tsv")) {
    if (row.size() == 2 && row[0] == set) folders.push_back(row[1]);
  }
  if (set != "gazebo_models") folders.emplace_back("gazebo_models");
  read::SearchPaths paths;
  for (const std::string& folder : folders) {
    paths.given.push_back({(fs::path(test::corpus()) / folder).string(), "--model-path"});
  }
  return paths;
}

TEST(CorpusCompat, AgreesWithTheOfficialChecker) {
  RIGOR_NEEDS_CORPUS();
  std::map<std::string, std::map<std::string, bool>> refused;  // by set and file
  for (const auto& row : compat_table(fs::path(test::corpus()) / "MANIFEST.tsv")) {
    if (row.size() < 7 || row[6].empty() || row[6] == "sdf12_verdict") continue;
    refused[row[0].substr(0, row[0].find('/'))][row[0]] = row[6] == "invalid";
  }
  // files by verdict: the checker's, then ours
  int count[2][2] = {};
  for (const auto& [set, files] : refused) {
    const RealDisk disk;
    const Environment environment(disk, compat_paths(set));
    for (const auto& [file, official] : files) {
      Sources sources;
      rules::ValidateOptions options{.paths = {test::corpus() + "/" + file},
                                     .meshes = rules::MeshPolicy::kDoNotOpen};
      options.selection.compat = rules::Compat::kSdformat;
      const auto result = rules::validate(environment, options, sources);
      const bool ours = result.diagnostics.count(Severity::kError) > 0;
      ++count[official ? 1 : 0][ours ? 1 : 0];
      if (ours == official) continue;
      std::printf("%s: %s, not by %s\n", file.c_str(), "refused",
                  official ? "rigor" : "the official checker");
    }
  }
  const int all = count[0][0] + count[0][1] + count[1][0] + count[1][1];
  std::printf(
      "refused by both %d, by the official checker alone %d, by rigor alone %d, by neither %d\n",
      count[1][1], count[1][0], count[0][1], count[0][0]);
  ASSERT_GE(all, 1500) << "another corpus?";
  // All agree when this was written. A file or two may change sides with a new rule; no more.
  EXPECT_LE(count[1][0], 2);
  EXPECT_LE(count[0][1], 2);
}

}  // namespace
}  // namespace rigor
