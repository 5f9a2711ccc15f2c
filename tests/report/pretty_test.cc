// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/pretty.h>

#include <string>

#include <gtest/gtest.h>

#include <rigor/report/terminal/concise.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

struct Case {
  Sources sources;
  SourceId arm = sources.add("arm/model.sdf", "<limit>\n  <lower>1</lower>\n  <upper>-1</upper>\n");
  Diagnostics diagnostics;
  Span lower{arm, 17, 18};
  Span upper{arm, 36, 38};
};

TEST(Pretty, NothingToSay) { EXPECT_EQ(pretty({}, Sources(), Color::kPlain), ""); }

TEST(Pretty, OneFinding) {
  Case c;
  c.diagnostics.add({.rule = "joint-limit-inverted",
                     .severity = Severity::kError,
                     .message = "lower (1) is above upper (-1) rad",
                     .where = c.lower,
                     .subject = "arm/joint elbow",
                     .related = {{c.upper, "the upper limit"}},
                     .help = "swap them",
                     .fixes = {{"swap lower and upper", Applicability::kUnsafe, {}}}});
  EXPECT_EQ(pretty(c.diagnostics, c.sources, Color::kPlain),
            "error[joint-limit-inverted]: lower (1) is above upper (-1) rad\n"
            " --> arm/model.sdf:2:10\n"
            "  |\n"
            "2 |   <lower>1</lower>\n"
            "  |          ^\n"
            "3 |   <upper>-1</upper>\n"
            "  |          -- the upper limit\n"
            "  |\n"
            "  = in: arm/joint elbow\n"
            "  = help: swap them\n"
            "  = unsafe fix: swap lower and upper\n"
            "\n");
}

TEST(Pretty, LabelInAnotherFile) {
  Case c;
  const SourceId hand = c.sources.add("hand/model.sdf", "<sdf>\n");
  c.diagnostics.add({.rule = "include-has-problems",
                     .severity = Severity::kInfo,
                     .message = "included",
                     .where = c.lower,
                     .related = {{{hand, 0, 5}, "here"}}});
  EXPECT_EQ(pretty(c.diagnostics, c.sources, Color::kPlain),
            "info[include-has-problems]: included\n"
            " --> arm/model.sdf:2:10\n"
            "  |\n"
            "2 |   <lower>1</lower>\n"
            "  |          ^\n"
            "  |\n"
            " ::: hand/model.sdf:1:1\n"
            "  |\n"
            "1 | <sdf>\n"
            "  | ----- here\n"
            "  |\n"
            "\n");
}

TEST(Pretty, FindingWithoutAText) {
  Case c;
  c.diagnostics.add({.rule = "mesh-truncated",
                     .severity = Severity::kWarning,
                     .message = "ends after 80 of 684 bytes",
                     .path = "meshes/wheel.stl",
                     .related = {{{}, "used by arm/link wheel"}},
                     .fixes = {{"export it again", Applicability::kManual, {}}}});
  EXPECT_EQ(pretty(c.diagnostics, c.sources, Color::kPlain),
            "warning[mesh-truncated]: ends after 80 of 684 bytes\n"
            " --> meshes/wheel.stl\n"
            "  = note: used by arm/link wheel\n"
            "  = possible fix, for you to decide: export it again\n"
            "\n");
}

TEST(Pretty, ColorOnlyDecorates) {
  Case c;
  c.diagnostics.add({.rule = "r", .message = "m", .where = c.lower, .related = {{c.upper, "l"}}});
  std::string colored = pretty(c.diagnostics, c.sources, Color::kAnsi);
  EXPECT_TRUE(colored.starts_with("\x1b[1;31merror[r]\x1b[0m"));
  for (std::size_t at; (at = colored.find('\x1b')) != std::string::npos;) {
    colored.erase(at, colored.find('m', at) - at + 1);
  }
  EXPECT_EQ(colored, pretty(c.diagnostics, c.sources, Color::kPlain));
}

TEST(Pretty, NamesFromAFileCannotDriveTheTerminal) {
  Case c;
  c.diagnostics.add({.rule = "r", .message = "\x1b[2J", .path = "a\x1b]0;\x07\nb"});
  const std::string text = pretty(c.diagnostics, c.sources, Color::kPlain);
  EXPECT_EQ(text, "error[r]: ␛[2J\n --> a␛]0;␇ b\n\n");
}

TEST(Concise, OneLineEach) {
  Case c;
  c.diagnostics.add({.rule = "joint-limit-inverted",
                     .severity = Severity::kError,
                     .message = "lower (1) is above\n    upper (-1)",
                     .where = c.lower});
  c.diagnostics.add({.rule = "mesh-missing",
                     .severity = Severity::kWarning,
                     .message = "no such file",
                     .path = "wheel.stl"});
  EXPECT_EQ(concise(c.diagnostics, c.sources),
            "arm/model.sdf:2:10: error: lower (1) is above upper (-1) [joint-limit-inverted]\n"
            "wheel.stl: warning: no such file [mesh-missing]\n");
}

TEST(Summary, SaysHowMuchWasChecked) {
  rules::ValidateResult result;
  EXPECT_EQ(summary(result), "no files checked");
  result.files = {{.path = "a.sdf"}};
  EXPECT_EQ(summary(result), "1 file checked, no problems");
  result.files.resize(12);
  EXPECT_EQ(summary(result), "12 files checked, no problems");
  result.diagnostics.add({.severity = Severity::kWarning});
  result.diagnostics.add({.severity = Severity::kError});
  result.diagnostics.add({.severity = Severity::kWarning});
  EXPECT_EQ(summary(result), "12 files checked: 1 error, 2 warnings");
  result.not_looked_at = {{"a.sdf", "include of https://example.org/arm"}};
  EXPECT_EQ(summary(result), "12 files checked: 1 error, 2 warnings; 1 include skipped");
  EXPECT_EQ(left_out(result), "");
  result.not_looked_at.push_back({"b.sdf.erb", "template: expand it first"});
  EXPECT_EQ(summary(result), "12 files checked: 1 error, 2 warnings; 1 include, 1 file skipped");
  EXPECT_EQ(left_out(result), "skipped: b.sdf.erb: template: expand it first\n");
  result.not_looked_at.push_back({"c.urdf", "assembly: meshes are not opened"});
  EXPECT_EQ(summary(result),
            "12 files checked: 1 error, 2 warnings; 1 include, 1 file, assembly of 1 file skipped");
}

TEST(Summary, CountsInThousands) {
  EXPECT_EQ(counted(0, "link"), "0 links");
  EXPECT_EQ(counted(1, "link"), "1 link");
  EXPECT_EQ(counted(999, "link"), "999 links");
  EXPECT_EQ(counted(1000, "link"), "1,000 links");
  EXPECT_EQ(counted(1234567, "link"), "1,234,567 links");
}

}  // namespace
}  // namespace rigor::report
