// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/baseline.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>

namespace rigor::rules {
namespace {

using Tree = std::map<std::string, std::string>;

/// A run over files below /w, which is the working folder; the baseline's is /w too.
struct BaselineCheck {
  explicit BaselineCheck(const Tree& files, ValidateOptions chosen = {})
      : disk(files), environment(disk, {}), options(std::move(chosen)) {
    if (options.paths.empty()) options.paths = {"/w"};
    result = validate(environment, options, sources);
  }

  BaselineRun run(const std::string& folder = "/w") const {
    return {environment, options, result, {folder, "/w"}};
  }
  BaselineResult with(const Baseline& baseline) const {
    return apply_baseline(baseline, run(), result);
  }

  MemoryDisk disk;
  Environment environment;
  ValidateOptions options;
  Sources sources;
  ValidateResult result;
};

/// A model with so many elements that no format knows, a warning each.
std::string with_unknown(int count) {
  std::string text = "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>";
  for (int i = 0; i < count; ++i) text += "<zz/>";
  return text + "</model></sdf>";
}

const char* const kRule = "unknown-element";

std::vector<std::string> stale_of(const BaselineResult& result) {
  std::vector<std::string> lines;
  for (const StaleBaseline& stale : result.stale) {
    lines.push_back(stale.key.path + " " + stale.key.rule + " " + std::to_string(stale.counted) +
                    " " + std::to_string(stale.now));
  }
  return lines;
}

TEST(BaselineText, IsReadAsItWasWritten) {
  Baseline baseline{{{"models/arm/model.sdf", "axis-zero"}, 3},
                    {{"../other repo/a b.sdf", "mass-zero"}, 1},
                    {{"#no comment", "mass-zero"}, 1000000000}};
  for (int byte = 1; byte < 256; ++byte) {  // no path has a zero
    const auto c = static_cast<char>(byte);
    baseline[{std::string("a") + c + "b" + c, "x"}] = static_cast<std::size_t>(byte);
    baseline[{std::string(1, c), "x"}] = 7;
    baseline[{std::string("\\") + c, "x"}] = 7;
  }
  const std::string text = baseline_text(baseline);
  const BaselineFile file = read_baseline(text);
  EXPECT_TRUE(file.problems.empty());
  EXPECT_EQ(file.baseline, baseline);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(baseline_text(file.baseline), text);
}

TEST(BaselineText, HasALineAnEntrySortedByPath) {
  const Baseline baseline{
      {{"b.sdf", "a-rule"}, 2}, {{"a.sdf", "z-rule"}, 1}, {{"a.sdf", "b-rule"}, 9}};
  const std::string text = baseline_text(baseline);
  EXPECT_EQ(text.front(), '#');
  EXPECT_EQ(text.substr(text.find('\n') + 1), "9 b-rule a.sdf\n1 z-rule a.sdf\n2 a-rule b.sdf\n");
}

TEST(BaselineText, IsReadInAnyOrderWithAnyLineEnds) {
  const BaselineFile file =
      read_baseline("\xEF\xBB\xBF# known\r\n\r\n2 b-rule b\\sc.sdf\r\n# more\n1 a-rule a.sdf");
  EXPECT_TRUE(file.problems.empty());
  EXPECT_EQ(file.baseline, (Baseline{{{"a.sdf", "a-rule"}, 1}, {{"b c.sdf", "b-rule"}, 2}}));
}

TEST(BaselineText, NamesTheLineOfWhatIsWrong) {
  for (const char* line :
       {"<<<<<<< HEAD", "axis-zero a.sdf", "3", "3 ", "3 axis-zero", "3 axis-zero ", "3  a.sdf",
        "-3 axis-zero a.sdf", "3axis-zero a.sdf", "0 axis-zero a.sdf", "1000000001 axis-zero a.sdf",
        "99999999999999999999999 axis-zero a.sdf", "3 axis-zero a b.sdf", "3 axis-zero a\\q.sdf",
        "3 axis-zero a\\", "3 axis-zero a\\x4", "3 axis-zero a\\xzz", "1 b-rule b.sdf"}) {
    const BaselineFile file =
        read_baseline(std::string("# known\n1 b-rule b.sdf\n") + line + "\n2 c-rule c.sdf\n");
    ASSERT_EQ(file.problems.size(), 1U) << line;
    EXPECT_EQ(file.problems.front().line, 3U) << line;
  }
  std::string wrong;
  for (int i = 0; i < 100'000; ++i) wrong += "wrong\n";
  EXPECT_EQ(read_baseline(wrong).problems.size(), 10U);
}

TEST(Baseline, HidesAsManyAsItCounts) {
  const BaselineCheck check(Tree{{"/w/a.sdf", with_unknown(3)}, {"/w/b.sdf", with_unknown(2)}});
  const BaselineResult applied = check.with({{{"a.sdf", kRule}, 3}});
  EXPECT_EQ(applied.hidden, 3U);
  EXPECT_TRUE(applied.stale.empty());
  ASSERT_EQ(applied.left.files.size(), 2U);
  EXPECT_EQ(applied.left.files[0].end_finding, 0U);
  EXPECT_EQ(applied.left.files[1].first_finding, 0U);
  EXPECT_EQ(applied.left.files[1].end_finding, 2U);
  EXPECT_EQ(applied.left.diagnostics.list().size(), 2U);
  EXPECT_EQ(applied.left.all_files, check.result.all_files);
}

TEST(Baseline, ShowsAllOfAPairThatHasMore) {
  const BaselineCheck check(Tree{{"/w/a.sdf", with_unknown(5)}});
  const BaselineResult applied = check.with({{{"a.sdf", kRule}, 3}});
  EXPECT_EQ(applied.hidden, 0U);
  ASSERT_EQ(applied.left.diagnostics.list().size(), 5U);
  for (const Diagnostic& diagnostic : applied.left.diagnostics.list()) {
    EXPECT_NE(diagnostic.help.find("3 of these in this file are in the baseline, 5 now"),
              std::string::npos);
  }
}

TEST(Baseline, SaysWhatIsStale) {
  const BaselineCheck check(Tree{{"/w/a.sdf", with_unknown(3)}});
  const BaselineResult applied = check.with({{{"a.sdf", kRule}, 4},
                                             {{"a.sdf", "axis-zero"}, 1},
                                             {{"a.sdf", "rule-of-old"}, 1},
                                             {{"gone.sdf", kRule}, 2}});
  EXPECT_EQ(applied.hidden, 3U);
  EXPECT_EQ(stale_of(applied), (std::vector<std::string>{
                                   "a.sdf axis-zero 1 0", "a.sdf rule-of-old 1 0",
                                   "a.sdf unknown-element 4 3", "gone.sdf unknown-element 2 0"}));
}

TEST(Baseline, IsNotStaleWhereTheRunDidNotLook) {
  const Tree files{{"/w/a.sdf", with_unknown(0)}, {"/w/b.sdf", with_unknown(0)}};
  const Baseline baseline{
      {{"a.sdf", "inertia-identity"}, 1}, {{"a.sdf", kRule}, 1}, {{"b.sdf", kRule}, 1}};
  const auto stale = [&](ValidateOptions options) {
    return BaselineCheck(files, std::move(options)).with(baseline).stale.size();
  };
  EXPECT_EQ(stale({}), 3U);
  EXPECT_EQ(stale({.paths = {"/w/a.sdf"}}), 2U);
  EXPECT_EQ(stale({.selection = {.ignore = {"schema"}}}), 1U);
  EXPECT_EQ(stale({.selection = {.select = {"kinematics"}}}), 0U);
  EXPECT_EQ(stale({.meshes = MeshPolicy::kDoNotOpen}), 2U);
  const auto of_b = [](const std::string& path) {
    return path == "/w/b.sdf" ? Selection{.ignore = {kRule}} : Selection{};
  };
  EXPECT_EQ(stale({.selection_for = of_b}), 2U);
}

TEST(Baseline, OfAFlexIsNotStaleWhereItsFileWasNotOpened) {
  const auto run = [](const std::string& faces, ValidateOptions options) {
    const std::string flex = "<flexcomp name='f' type='mesh' file='f.obj' mass='1'/>";
    return BaselineCheck(
        {{"/w/a.xml", "<mujoco model='m'><worldbody>" + flex + "</worldbody></mujoco>"},
         {"/w/f.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + faces}},
        std::move(options));
  };
  const Baseline baseline{{{"a.xml", "mjcf-flex-file"}, 1}};
  ValidateOptions closed{.paths = {"/w/a.xml"}, .meshes = MeshPolicy::kDoNotOpen};
  const ValidateOptions open{.paths = {"/w/a.xml"}};
  const auto found = [](const BaselineCheck& check) {
    const auto& list = check.result.diagnostics.list();
    return std::ranges::count(list, "mjcf-flex-file", &Diagnostic::rule);
  };
  EXPECT_EQ(found(run("", open)), 1);
  EXPECT_EQ(found(run("", closed)), 0);
  EXPECT_EQ(found(run("f 1 2 3\n", open)), 0);
  EXPECT_EQ(run("f 1 2 3\n", closed).with(baseline).stale.size(), 0U);
  EXPECT_EQ(run("f 1 2 3\n", open).with(baseline).stale.size(), 1U);
}

TEST(Baseline, OfAFileThatIsCutIsKept) {
  const BaselineCheck check(Tree{{"/w/a.sdf", "<sdf version='1.9'><model name='m'><zz/>"}});
  const Baseline before{{{"a.sdf", kRule}, 4}, {{"a.sdf", "axis-zero"}, 2}};
  EXPECT_TRUE(check.with(before).stale.empty());
  EXPECT_EQ(pruned_baseline(before, check.run()), before);
  Baseline next = before;
  next[{"a.sdf", "xml-not-well-formed"}] = 1;
  EXPECT_EQ(next_baseline(before, check.run()), next);
}

TEST(Baseline, CountsWhatIsFoldedAsMany) {
  const BaselineCheck check(Tree{{"/w/a.sdf", with_unknown(25000)}});
  EXPECT_LT(check.result.diagnostics.list().size(), 11000U);
  EXPECT_EQ(check.run().found(), (Baseline{{{"a.sdf", kRule}, 25000}}));
  EXPECT_EQ(check.with({{{"a.sdf", kRule}, 24999}}).hidden, 0U);
  EXPECT_EQ(check.with({{{"a.sdf", kRule}, 25000}}).hidden, 25000U);
}

TEST(Baseline, NamesPathsFromItsOwnFolder) {
  const BaselineCheck check(Tree{{"/w/a b/c.sdf", with_unknown(1)}}, {.paths = {"/w/a b/c.sdf"}});
  EXPECT_EQ(check.run("/w").name("a b/c.sdf"), "a b/c.sdf");
  EXPECT_EQ(check.run("/w").name("/w/a b/../a b/c.sdf"), "a b/c.sdf");
  EXPECT_EQ(check.run("/w/ci").name("a b/c.sdf"), "../a b/c.sdf");
  EXPECT_EQ(check.run("/").name("a b/c.sdf"), "w/a b/c.sdf");
  EXPECT_EQ(check.run("/w/ci").found(), (Baseline{{{"../a b/c.sdf", kRule}, 1}}));
}

TEST(Baseline, ThatIsWrittenHidesEverythingAndIsNotStale) {
  const Baseline before{
      {{"a.sdf", "axis-zero"}, 7}, {{"a.sdf", kRule}, 1}, {{"other.sdf", kRule}, 4}};
  const Tree files{{"/w/a.sdf", with_unknown(3)},
                   {"/w/b.sdf", "<robot name='r'><link name='a'/><link name='a'/></robot>"},
                   {"/w/other.sdf", with_unknown(9)}};
  const BaselineCheck check(files, {.paths = {"/w/a.sdf", "/w/b.sdf"}});
  const Baseline next = next_baseline(before, check.run());
  const BaselineResult applied = check.with(next);
  EXPECT_TRUE(applied.left.diagnostics.list().empty());
  EXPECT_TRUE(applied.stale.empty());
  EXPECT_EQ(next.at({"a.sdf", kRule}), 3U);
  EXPECT_EQ(next.at({"other.sdf", kRule}), 4U);  // nobody looked
  EXPECT_FALSE(next.contains({"a.sdf", "axis-zero"}));
}

TEST(Baseline, ThatIsPrunedNeverGrows) {
  const Baseline before{{{"a.sdf", "axis-zero"}, 7}, {{"a.sdf", kRule}, 1}, {{"b.sdf", kRule}, 4}};
  const BaselineCheck check(Tree{{"/w/a.sdf", with_unknown(3)}, {"/w/b.sdf", with_unknown(2)}});
  const Baseline pruned = pruned_baseline(before, check.run());
  EXPECT_EQ(pruned, (Baseline{{{"a.sdf", kRule}, 1}, {{"b.sdf", kRule}, 2}}));
  EXPECT_EQ(pruned_baseline(pruned, check.run()), pruned);
  EXPECT_EQ(check.with(pruned).hidden, check.with(before).hidden);
}

}  // namespace
}  // namespace rigor::rules
