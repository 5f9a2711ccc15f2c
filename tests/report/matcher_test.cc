// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The problem matcher that makes GitHub read the format `concise`, .github/rigor-matcher.json.

#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/found.h>
#include <rigor/report/terminal/concise.h>
#include <support/corpus.h>

namespace rigor::report {
namespace {

using MatcherJson = nlohmann::json;

/// What GitHub would take out of a line, by the name of the property; with the matcher's owner.
using Matched = std::map<std::string, std::string>;

std::vector<Matched> matches_of(const std::string& line) {
  const MatcherJson matchers = MatcherJson::parse(
      test::read_file(std::string(RIGOR_SOURCE_DIR) + "/.github/rigor-matcher.json"));
  std::vector<Matched> all;
  for (const MatcherJson& matcher : matchers["problemMatcher"]) {
    const MatcherJson& pattern = matcher["pattern"].at(0);
    const std::regex regex(pattern["regexp"].get<std::string>(), std::regex::ECMAScript);
    std::smatch groups;
    if (!std::regex_match(line, groups, regex)) continue;
    Matched matched = {{"owner", matcher["owner"]}};
    if (matcher.contains("severity")) matched["severity"] = matcher["severity"];
    for (const auto& [name, group] : pattern.items()) {
      if (group.is_number()) matched[name] = groups[group.get<std::size_t>()];
    }
    all.push_back(matched);
  }
  return all;
}

/// The line that `concise` prints of a finding.
std::string printed(const std::string& path, Diagnostic diagnostic) {
  Found found;
  found.file(path, "<a>\n  b");
  const bool mesh = !diagnostic.path.empty();
  if (mesh) {
    found.add(std::move(diagnostic));
  } else {
    found.at("b", std::move(diagnostic));
  }
  std::string line = concise(found.result.diagnostics, found.sources);
  line.pop_back();
  return line;
}

using AllMatched = std::vector<Matched>;

TEST(ProblemMatcher, TakesAFindingApart) {
  EXPECT_EQ(matches_of(printed("my robots/arm:2.sdf", {.message = "it: [0] is 'x' [sic]"})),
            (AllMatched{{{"owner", "rigor"},
                         {"file", "my robots/arm:2.sdf"},
                         {"line", "2"},
                         {"column", "3"},
                         {"severity", "error"},
                         {"message", "it: [0] is 'x' [sic]"},
                         {"code", "axis-zero"}}}));
  const auto warning = matches_of(
      printed("a.sdf", {.severity = Severity::kWarning, .message = "b.sdf:1:2: error: said"}));
  ASSERT_EQ(warning.size(), 1U);
  EXPECT_EQ(warning[0].at("file"), "a.sdf");
  EXPECT_EQ(warning[0].at("severity"), "warning");
  EXPECT_EQ(warning[0].at("message"), "b.sdf:1:2: error: said");
}

TEST(ProblemMatcher, AFindingWithoutATextHasItsFile) {
  EXPECT_EQ(matches_of(printed("a.sdf", {.message = "no triangles", .path = "meshes/wheel.stl"})),
            (AllMatched{{{"owner", "rigor-file"},
                         {"file", "meshes/wheel.stl"},
                         {"severity", "error"},
                         {"message", "no triangles"},
                         {"code", "axis-zero"}}}));
}

TEST(ProblemMatcher, AnInfoIsANotice) {
  EXPECT_EQ(matches_of(printed("a.sdf", {.severity = Severity::kInfo, .message = "it"})),
            (AllMatched{{{"owner", "rigor-info"},
                         {"file", "a.sdf"},
                         {"line", "2"},
                         {"column", "3"},
                         {"severity", "notice"},
                         {"message", "it"},
                         {"code", "axis-zero"}}}));
}

TEST(ProblemMatcher, PassesOverTheRest) {
  EXPECT_EQ(matches_of("12 files checked: 1 error, 2 warnings"), AllMatched());
  EXPECT_EQ(matches_of("rigor: nowhere: no such file or folder"), AllMatched());
}

}  // namespace
}  // namespace rigor::report
