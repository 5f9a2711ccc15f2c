// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/starter.h>

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/config/config.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/target.h>

#include "support/corpus.h"

namespace rigor::config {
namespace {

/// The keys that the reader knows in a table, as it lists them when it meets another one.
std::vector<std::string> keys_known_in(const std::string& header) {
  const Config config = read_config("rigor.toml", header + "no-such-key = 1\n");
  for (const Problem& problem : config.problems) {
    if (problem.name == "no-such-key") return problem.known;
  }
  ADD_FAILURE() << "the reader took no-such-key in " << header;
  return {};
}

/// The starter with each setting in use: what is commented out has no blank behind its sign.
std::string starter_in_use() {
  std::istringstream lines{std::string(starter_config())};
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const bool setting = line.size() > 1 && line[0] == '#' && line[1] != ' ';
    text += setting ? line.substr(1) : line;
    text += '\n';
  }
  return text;
}

TEST(Starter, ChangesNothing) {
  const Config config = read_config("/p/rigor.toml", starter_config());
  EXPECT_TRUE(config.problems.empty());
  EXPECT_FALSE(config.extend || config.root || config.fail_on || config.targets || config.baseline);
  EXPECT_FALSE(config.rules.select);
  EXPECT_TRUE(config.rules.ignore.empty());
  EXPECT_TRUE(config.per_file.empty());
}

TEST(Starter, EachSettingCanBeTakenIntoUse) {
  const Config config = read_config("/p/rigor.toml", starter_in_use());
  for (const Problem& problem : config.problems) {
    ADD_FAILURE() << problem.line << ": " << problem.message;
  }
  const rules::Registry registry;
  std::set<std::string> names;
  for (const rules::Rule& rule : registry.rules()) {
    names.emplace(rule.name);
    names.emplace(to_string(rule.category));
  }
  ASSERT_EQ(config.per_file.size(), 1U);
  const RuleChoice& some = config.per_file.front().rules;
  for (const auto& list : {*config.rules.select, config.rules.ignore, *some.select, some.ignore}) {
    for (const Name& name : list) EXPECT_TRUE(names.contains(name.value)) << name.value;
  }
  for (const auto& [rule, level] : config.rules.severity) {
    EXPECT_NE(registry.find(rule), nullptr) << rule;
  }
  for (const Name& target : *config.targets) {
    EXPECT_TRUE(rules::target_named(target.value)) << target.value;
  }
}

TEST(Starter, HasEveryKeyAndSoHaveTheDocs) {
  const std::string starter = starter_in_use();
  const std::string docs =
      test::read_file(std::string(RIGOR_SOURCE_DIR) + "/docs/configuration.md");
  for (const std::string header : {"", "[[per-file]]\n", "[resolve]\n"}) {
    const std::vector<std::string> keys = keys_known_in(header);
    EXPECT_FALSE(keys.empty());
    for (const std::string& key : keys) {
      const bool assigned = starter.find('\n' + key + " = ") != std::string::npos;
      const bool table = starter.find("\n[" + key + "]\n") != std::string::npos ||
                         starter.find("\n[[" + key + "]]\n") != std::string::npos;
      EXPECT_TRUE(assigned || table) << key << " is not in the starter";
      const bool documented = docs.find("`" + key + "`") != std::string::npos ||
                              docs.find("`[" + key + "]`") != std::string::npos ||
                              docs.find("`[[" + key + "]]`") != std::string::npos;
      EXPECT_TRUE(documented) << key << " is not in docs/configuration.md";
    }
  }
}

}  // namespace
}  // namespace rigor::config
