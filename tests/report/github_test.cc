// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/github.h>

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <report/found.h>

namespace rigor::report {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// What is said of so many findings of each kind, which stand in the file with infos first.
std::vector<std::string> lines_with(std::size_t errors, std::size_t warnings, std::size_t infos) {
  Found found;
  found.file("a.sdf", "x");
  const auto add = [&found](std::size_t count, Severity severity) {
    for (std::size_t i = 0; i < count; ++i) {
      found.at("x", {.severity = severity, .message = "it " + std::to_string(i)});
    }
  };
  add(infos, Severity::kInfo);
  add(warnings, Severity::kWarning);
  add(errors, Severity::kError);
  return lines_of(github(found.validation()));
}

std::size_t count_of(const std::vector<std::string>& lines, const std::string& begin) {
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(),
                    [&begin](const std::string& line) { return line.starts_with(begin); }));
}

TEST(Github, ACommandForEachFinding) {
  Found found;
  found.file("arm/model.sdf", "<a>\n <xyz>0 0 0</xyz>")
      .at("0 0 0", {.message = "the axis is 0 0 0", .help = "write another"});
  EXPECT_EQ(github(found.validation()),
            "::error title=rigor (axis-zero),file=arm/model.sdf,line=2,endLine=2,col=7,"
            "endColumn=12::arm/model.sdf:2:7: the axis is 0 0 0%0Ahelp: write another\n");
}

TEST(Github, ColumnsOnlyWithinOneLine) {
  Found found;
  found.file("a.sdf", "<a\n>").at("<a\n>", {.severity = Severity::kWarning, .message = "it"});
  EXPECT_EQ(github(found.validation()),
            "::warning title=rigor (axis-zero),file=a.sdf,line=1,endLine=2::a.sdf:1:1: it\n");
}

TEST(Github, WithoutATextOnlyTheFile) {
  Found found;
  found.file("a.sdf", "x")
      .add({.severity = Severity::kInfo, .message = "no triangles", .path = "wheel.stl"});
  EXPECT_EQ(github(found.validation()),
            "::notice title=rigor (axis-zero),file=wheel.stl::wheel.stl: no triangles\n");
}

// As actions/toolkit does: in data % CR LF, in properties colon and comma too.
TEST(Github, NothingInAFileBecomesACommandOrAProperty) {
  Found found;
  found.file("a,b:c%.sdf", "x y");
  Diagnostic diagnostic{.message = "100%\r\n::error::no, not: this"};
  diagnostic.related = {{found.span_of("y"), "at\n::warning::y"}};
  found.at("x", diagnostic);
  EXPECT_EQ(github(found.validation()),
            "::error title=rigor (axis-zero),file=a%2Cb%3Ac%25.sdf,line=1,endLine=1,col=1,"
            "endColumn=2::a,b:c%25.sdf:1:1: 100%25 ::error::no, not: this%0Aa,b:c%25.sdf:1:3: at "
            "::warning::y\n");
}

TEST(Github, TheFileIsSeenFromTheTopOfTheProject) {
  Found found;
  found.folders = {"/ci/repo/robots", "/ci/repo"};
  found.file("arm.sdf", "x").at("x", {.message = "it"});
  EXPECT_NE(github(found.validation()).find(",file=robots/arm.sdf,"), std::string::npos);
}

TEST(Github, TheMostSevereComeFirst) {
  const auto lines = lines_with(2, 1, 1);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(lines[0].starts_with("::error ") && lines[1].starts_with("::error "));
  EXPECT_TRUE(lines[2].starts_with("::warning ") && lines[3].starts_with("::notice "));
}

TEST(Github, SaysHowManyGithubDoesNotShow) {
  const auto all_shown = lines_with(10, 10, 10);
  EXPECT_EQ(all_shown.size(), 30U);
  // 2 errors and 1 warning too many; the notice that says so is the last.
  const auto some = lines_with(12, 11, 3);
  ASSERT_EQ(some.size(), 27U);
  EXPECT_TRUE(some.back().starts_with("::notice title=rigor::3 more findings in the log only"))
      << some.back();
  // With it there are eleven notices: it is the tenth, and two infos are not shown.
  const auto infos = lines_with(0, 0, 11);
  ASSERT_EQ(infos.size(), 12U);
  EXPECT_TRUE(infos[9].starts_with("::notice title=rigor::2 more findings")) << infos[9];
  EXPECT_EQ(count_of(infos, "::notice title=rigor (axis-zero)"), 11U);
}

TEST(Github, NothingIsSaidOfACleanRun) { EXPECT_EQ(github(Found().validation()), ""); }

TEST(GithubSummary, ListsAllAndKeepsTextText) {
  Found found;
  found.file("a.sdf", "x").at("x", {.message = "is <b>|[not](this)"});
  const std::string text = github_summary(found.validation());
  EXPECT_NE(text.find("1 file checked: 1 error"), std::string::npos) << text;
  EXPECT_NE(text.find("| error | a.sdf:1:1 | is \\<b\\>\\|\\[not\\](this) | axis-zero |\n"),
            std::string::npos)
      << text;
}

TEST(GithubSummary, StaysBelowWhatGithubTakes) {
  Found found;
  found.file("a.sdf", "x");
  for (int i = 0; i < 1500; ++i)
    found.at("x", {.message = std::to_string(i) + std::string(1000, 'm')});
  const std::string text = github_summary(found.validation());
  EXPECT_LE(text.size(), 1024U * 1024U);
  EXPECT_GT(text.size(), 900U * 1000U);
  const auto rows = lines_of(text);
  const std::size_t listed = count_of(rows, "| error");
  EXPECT_EQ(rows.back(), "And " + std::to_string(1500 - listed) + " more findings: see the log.");
}

}  // namespace
}  // namespace rigor::report
