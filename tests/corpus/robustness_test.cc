// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Damaged real files: whatever is cut off, rigor reads what is left, says something, and lives.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor {
namespace {

TEST(CorpusRobustness, EveryFileIsChecked) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {test::corpus()}}, sources);
  EXPECT_EQ(result.files.size(), test::corpus_models().size());
  EXPECT_TRUE(result.unusable.empty());
}

TEST(CorpusRobustness, FilesCutAnywhereGetADiagnostic) {
  RIGOR_NEEDS_CORPUS();
  constexpr std::size_t kLargest = 100'000;  // a few worlds would take most of the time
  const MemoryDisk disk;
  const Environment environment(disk, {});
  const auto paths = test::corpus_models();
  std::mt19937 random(200);
  for (int file = 0; file < 50;) {
    const std::string& path = paths[random() % paths.size()];
    const std::string text = test::read_file(path);
    if (text.size() > kLargest) continue;
    ++file;
    for (int cut = 0; cut < 200; ++cut) {
      const std::string part = text.substr(0, random() % (text.size() + 1));
      Sources sources;
      rules::ValidateOptions options;
      options.buffer = {"cut.sdf", part};
      const auto result = rules::validate(environment, options, sources);
      // Cut before the last end tag, it is not XML.
      if (part.size() < text.rfind("</")) {
        EXPECT_GT(result.diagnostics.count(Severity::kError), 0U) << path << " at " << part.size();
      }
    }
  }
}

}  // namespace
}  // namespace rigor
