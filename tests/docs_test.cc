// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the documents show is what rigor prints.

#include <gtest/gtest.h>

#include <string>

#include <rigor/report/rules/list.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

#include "support/corpus.h"

namespace rigor {
namespace {

const std::string kRoot = std::string(RIGOR_SOURCE_DIR) + "/";

/// The first block of a language in a Markdown text.
std::string block(const std::string& text, const std::string& language) {
  const std::string open = "```" + language + "\n";
  const std::size_t begin = text.find(open) + open.size();
  return text.substr(begin, text.find("```\n", begin) - begin);
}

TEST(Readme, FirstScreenIsWhatRigorPrints) {
  const std::string readme = test::read_file(kRoot + "README.md");
  MemoryDisk disk;
  disk.put("cart.sdf", block(readme, "xml"));
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {"cart.sdf"}}, sources);
  EXPECT_EQ(
      report::pretty(result.diagnostics, sources, report::Color::kPlain, environment.registry),
      block(readme, "text"));
}

TEST(RulesPage, HasAPageForEveryRule) {
  const rules::Registry registry;
  const std::string page = report::rules_markdown(registry);
  for (const rules::Rule& rule : registry.rules()) {
    EXPECT_NE(page.find("\n## " + std::string(rule.name) + "\n"), std::string::npos) << rule.name;
  }
  EXPECT_EQ(page.find("«"), std::string::npos) << "marks are for the tests";
}

TEST(Demo, NothingCallsTheTutorialsRobotWrong) {
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const auto result =
      rules::validate(environment, {.paths = {std::string(RIGOR_TESTDATA) + "models"}}, sources);
  EXPECT_EQ(result.diagnostics.count(Severity::kError), 0U);
  int missing = 0;
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    EXPECT_EQ(diagnostic.rule, "inertial-missing") << "1.5707 for π/2 is what real files hold";
    ++missing;
  }
  EXPECT_EQ(missing, 3) << "the chassis and the two wheels";
}

}  // namespace
}  // namespace rigor
