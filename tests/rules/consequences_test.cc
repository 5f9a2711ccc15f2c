// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/consequences.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/registry.h>

namespace rigor::rules {
namespace {

Diagnostic found(std::string_view rule, Severity severity, std::string subject,
                 std::string cause = {}) {
  Diagnostic finding;
  finding.rule = rule;
  finding.severity = severity;
  finding.subject = std::move(subject);
  finding.cause = std::move(cause);
  return finding;
}

using Rules = std::vector<std::string_view>;

Rules rules_left(std::vector<Diagnostic> findings) {
  Diagnostics list;
  for (Diagnostic& finding : findings) list.add(std::move(finding));
  Rules rules;
  const Diagnostics left = without_consequences(std::move(list));
  for (const Diagnostic& finding : left.list()) rules.push_back(finding.rule);
  return rules;
}

constexpr Severity kError = Severity::kError;
constexpr Severity kWarning = Severity::kWarning;

TEST(Consequences, OfTheSameSubjectAreHidden) {
  EXPECT_EQ(rules_left({found("inertia-singular", kWarning, "arm/link a"),
                        found("inertia-triangle-inequality", kError, "arm/link a"),
                        found("inertia-singular", kWarning, "arm/link b")}),
            (Rules{"inertia-triangle-inequality", "inertia-singular"}));
}

TEST(Consequences, OfAPartAreHiddenOfTheWhole) {
  EXPECT_EQ(rules_left({found("visual-collision-scale", kWarning, "arm/link a"),
                        found("value-malformed", kError, "arm/link a/collision c")}),
            Rules{"value-malformed"});
  EXPECT_EQ(rules_left({found("visual-collision-scale", kWarning, "arm/link a/collision c"),
                        found("value-malformed", kError, "arm/link a")})
                .size(),
            2U);
}

TEST(Consequences, AreNotHiddenByWhatIsLessSevere) {
  EXPECT_EQ(rules_left({found("inertia-singular", kError, "arm/link a"),
                        found("inertia-identity", kWarning, "arm/link a")})
                .size(),
            2U);
}

TEST(Consequences, AllThatReferToAMissingNameFollowFromOne) {
  EXPECT_EQ(rules_left({found("joint-parent-missing", kError, "arm/joint a", "boby"),
                        found("gazebo-reference-missing", kWarning, "", "boby"),
                        found("gazebo-reference-missing", kWarning, "", "tip")}),
            (Rules{"joint-parent-missing", "gazebo-reference-missing"}));
}

TEST(Consequences, AreOfRulesThatExistAndNeverGoInACycle) {
  const Registry registry;
  const auto words = [](std::string_view list) {
    std::istringstream stream{std::string(list)};
    std::vector<std::string> names;
    for (std::string name; stream >> name;) names.push_back(name);
    return names;
  };
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const Consequences& row : consequences()) {
    for (const std::string& root : words(row.roots)) {
      EXPECT_NE(registry.find(root), nullptr) << root;
      for (const std::string& rule : words(row.rules)) {
        EXPECT_NE(registry.find(rule), nullptr) << rule;
        pairs.emplace_back(root, rule);
      }
    }
  }
  // A rule that hides another is not hidden by it, however many stand between.
  for (std::size_t round = 0; round < pairs.size(); ++round) {
    const std::size_t before = pairs.size();
    std::vector<std::pair<std::string, std::string>> more;
    for (const auto& [root, rule] : pairs) {
      ASSERT_NE(root, rule);
      for (const auto& [next, last] : pairs) {
        const std::pair<std::string, std::string> pair{root, last};
        const auto is = [&pair](const auto& other) { return other == pair; };
        if (next == rule && std::none_of(pairs.begin(), pairs.end(), is) &&
            std::none_of(more.begin(), more.end(), is)) {
          more.push_back(pair);
        }
      }
    }
    pairs.insert(pairs.end(), more.begin(), more.end());
    if (pairs.size() == before) break;
  }
}

}  // namespace
}  // namespace rigor::rules
