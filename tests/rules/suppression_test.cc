// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/suppression.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

using Lines = std::vector<std::string>;
using DiskFiles = std::map<std::string, std::string>;

/// "LINE RULE" of every finding of `a.sdf`, in order; of other files with their path before it.
Lines told_of(const DiskFiles& files, ValidateOptions options = {}) {
  const MemoryDisk disk(files);
  const Environment environment(disk, {});
  Sources sources;
  if (options.paths.empty()) options.paths = {"a.sdf"};
  const ValidateResult result = validate(environment, options, sources);
  Lines lines;
  for (const Diagnostic& found : result.diagnostics.list()) {
    const SourceId source = found.where.source;
    const std::string path = found.where.nowhere() ? found.path : std::string(sources.path(source));
    const std::uint32_t line =
        found.where.nowhere() ? 0 : sources.position(source, found.where.begin).line;
    lines.push_back((path == "a.sdf" ? "" : path + " ") + std::to_string(line) + " " +
                    std::string(found.rule));
  }
  return lines;
}

Lines told_of(const std::string& text) { return told_of(DiskFiles{{"a.sdf", text}}); }

/// A model with these lines in it, from line 2 on.
std::string model_of(const std::string& lines) {
  return "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>\n" + lines +
         "</model></sdf>\n";
}

// Each <zz/> is an unknown-element; a pose that is no pose is a value-malformed.
const char* const kBadPose = "<pose>wide</pose>";

TEST(Suppression, CoversTheNextElementAndAllItContains) {
  EXPECT_EQ(
      told_of(model_of("<link name='a'><zz/><visual name='v'><zz/></visual></link>\n<zz/>\n")),
      (Lines{"2 unknown-element", "2 geometry-missing", "2 unknown-element", "3 unknown-element"}));
  EXPECT_EQ(
      told_of(model_of("<!-- rigor: ignore[unknown-element, geometry-missing] ours -->\n"
                       "<link name='a'><zz/><visual name='v'><zz/></visual></link>\n<zz/>\n")),
      Lines{"4 unknown-element"});
}

TEST(Suppression, PassesOverTextAndCommentsToTheElement) {
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[unknown-element] -->\n"
                             "<!-- a comment with <zz/> -->\n\n"
                             "<!--\trigor:ignore [ value-malformed ,]\n twice\n-->\n"
                             "<link name='a'><zz/><pose>wide</pose></link>\n<zz/>\n")),
            Lines{"9 unknown-element"});
}

TEST(Suppression, CoversNothingBehindTheEndOfItsParent) {
  // The comment's parent ends before another element begins: the link of line 3 is not its sibling.
  EXPECT_EQ(told_of(model_of("<link name='a'><!-- rigor: ignore[unknown-element] --></link>\n"
                             "<link name='b'><zz/></link>\n")),
            (Lines{"2 unused-suppression", "3 unknown-element"}));
}

TEST(Suppression, OfAnElementInsideAnotherLeavesTheOther) {
  EXPECT_EQ(told_of(model_of("<link name='a'><zz/>\n<!-- rigor: ignore[unknown-element] -->\n"
                             "<visual name='v'><zz/><geometry><empty/></geometry></visual>\n"
                             "<zz/></link>\n")),
            (Lines{"2 unknown-element", "5 unknown-element"}));
}

TEST(Suppression, OfAnInnerAndAnOuterElementAreBothUsed) {
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[unknown-element] -->\n<link name='a'>\n"
                             "<!-- rigor: ignore[schema] -->\n<zz/></link>\n")),
            Lines{});
}

TEST(Suppression, ThatIsSaidTwiceIsUnusedOnce) {
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[unknown-element] -->\n"
                             "<!-- rigor: ignore[unknown-element] -->\n<zz/>\n")),
            Lines{"3 unused-suppression"});
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore-next[unknown-element] -->\n"
                             "<!-- rigor: ignore[unknown-element] -->\n<zz><y/></zz>\n")),
            Lines{"2 unused-suppression"});
}

TEST(Suppression, OfATagLeavesWhatTheElementHolds) {
  const std::string link = "<link name='a' color='red'><pose speed='1'>wide</pose></link>\n";
  EXPECT_EQ(told_of(model_of(link)),
            (Lines{"2 unknown-attribute", "2 unknown-attribute", "2 value-malformed"}));
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore-next[unknown-attribute] -->" + link)),
            (Lines{"2 unknown-attribute", "2 value-malformed"}));
}

TEST(Suppression, CoversAValueThatIsNotThere) {
  for (const std::string gravity : {"<gravity></gravity>", "<gravity/>"}) {
    const auto link = [&](const std::string& comment) {
      return model_of("<link name='a'>" + comment + gravity + "</link>\n");
    };
    const Lines all = told_of(link(""));
    EXPECT_EQ(std::count(all.begin(), all.end(), "2 value-empty"), 1) << gravity;
    const Lines left = told_of(link("<!-- rigor: ignore[value-empty] -->"));
    EXPECT_EQ(std::count(left.begin(), left.end(), "2 value-empty"), 0) << gravity;
    EXPECT_EQ(left.size() + 1, all.size());
  }
}

TEST(Suppression, TakesNamesOfCategories) {
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[schema] -->\n"
                             "<link name='a'><zz/><pose>wide</pose></link>\n")),
            Lines{});
}

TEST(Suppression, OfAFileStandsBeforeItsRoot) {
  const std::string model = model_of("<zz/>\n<link name='a'><zz/></link>\n");
  const std::string comment = "<!-- rigor: file-ignore[unknown-element] -->\n";
  EXPECT_EQ(told_of(comment + model), Lines{});
  EXPECT_EQ(told_of("<?xml version='1.0'?>\n" + comment + model), Lines{});
  EXPECT_EQ(told_of("\xEF\xBB\xBF<?xml version='1.0'?>\n" + comment + model), Lines{});
  EXPECT_EQ(told_of(model + comment),
            (Lines{"2 unknown-element", "3 unknown-element", "5 malformed-suppression"}));
}

TEST(Suppression, OfAFileCoversWhatStandsNowhereAndElsewhere) {
  Sources sources;
  const SourceId file = sources.add("a.sdf", "<!-- rigor: file-ignore[mesh] --><sdf/>");
  const SourceId same = sources.add("b.sdf", "<!-- rigor: ignore[mesh] --><sdf/>");
  const SourceId other = sources.add("c.sdf", "<sdf/>");
  for (const SourceId source : {file, same}) {
    Diagnostics found;
    found.add({.rule = "mesh-empty", .category = "mesh", .path = "meshes/a.stl"});
    found.add({.rule = "mesh-empty", .category = "mesh", .where = {other, 1, 4}});
    found.add({.rule = "axis-zero", .category = "kinematics", .where = {source, 35, 38}});
    Suppressions suppressions(xml::parse(sources.bytes(source), source));
    const Diagnostics left = suppressions.uncovered(std::move(found));
    EXPECT_EQ(left.list().size(), source == file ? 1U : 3U);
  }
}

TEST(Suppression, IsNotSeenInProse) {
  for (const char* comment :
       {"<!-- see rigor: ignore[unknown-element] -->", "<!-- rigor ignore[unknown-element] -->",
        "<!-- Rigor: ignore[unknown-element] -->", "<!-- for rigor: -->",
        "<!-- rigorous: ignore[unknown-element] -->", "<!---->", "<!-- rigor -->"}) {
    EXPECT_EQ(told_of(model_of(std::string(comment) + "\n<zz/>\n")), Lines{"3 unknown-element"})
        << comment;
  }
  EXPECT_EQ(told_of(model_of("<![CDATA[<!-- rigor: ignore[a] -->]]>\n")),
            Lines{"2 text-between-elements"});
}

TEST(Suppression, IsNeverOfEverything) {
  for (const char* comment :
       {"<!-- rigor: ignore -->", "<!-- rigor: ignore[] -->", "<!-- rigor: ignore[ , ] -->",
        "<!-- rigor: ignore[all] -->", "<!-- rigor: ignore[*] -->", "<!-- rigor: -->",
        "<!-- rigor: ignore[unknown-element -->", "<!-- rigor: disable[unknown-element] -->",
        "<!-- rigor: ignore unknown-element -->"}) {
    EXPECT_EQ(told_of(model_of(std::string(comment) + "\n<zz/>\n")),
              (Lines{"2 malformed-suppression", "3 unknown-element"}))
        << comment;
  }
}

/// The first finding of a rule.
Diagnostic first_of(const std::string& text, std::string_view rule) {
  const MemoryDisk disk(DiskFiles{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule == rule) return {.message = found.message, .help = found.help};
  }
  return {};
}

TEST(Suppression, SuggestsWhatWasMeant) {
  EXPECT_EQ(
      first_of(model_of("<!-- rigor: ignore[unknown-elemnt] --><zz/>"), "unknown-suppression").help,
      "did you mean 'unknown-element'?");
  EXPECT_EQ(first_of(model_of("<!-- rigor: ignore[schmea] --><zz/>"), "unknown-suppression").help,
            "did you mean 'schema'?");
  EXPECT_EQ(
      first_of(model_of("<!-- rigor: ignore[axis-zero mesh-empty] --><zz/>"), "unknown-suppression")
          .help,
      "put commas between names");
  EXPECT_EQ(
      first_of(model_of("<!-- rigor: ignore-nxt[mesh] --><zz/>"), "malformed-suppression").help,
      "did you mean 'ignore-next'?");
}

TEST(Suppression, OfACutFileCountsAsFarAsItWasRead) {
  const std::string cut = model_of(
      "<!-- rigor: ignore[unknown-element] -->\n<zz/>\n<zz/>\n"
      "<!-- rigor: ignore[axis-zero] -->\n<link name='b'></model>\n");
  EXPECT_EQ(told_of(cut), (Lines{"4 unknown-element", "6 xml-not-well-formed"}));
}

TEST(Suppression, NeverHidesWhatEndedTheReading) {
  // Nothing behind such a fault is examined, so that nobody may say that all is well.
  for (const std::string name : {"xml", "xml-not-well-formed"}) {
    const std::string comment = "<!-- rigor: file-ignore[" + name + "] -->\n";
    EXPECT_EQ(told_of(comment + model_of("<link name='b'>\n")), Lines{"4 xml-not-well-formed"});
    EXPECT_EQ(told_of(comment + "<sdf version='1.9'>\n"), Lines{"3 xml-not-well-formed"});
  }
  EXPECT_EQ(told_of("<!-- rigor: file-ignore[xml-empty] -->"), Lines{"1 xml-empty"});
  // What is not fatal is hidden.
  const std::string dashes = model_of("<!-- -- -->\n");
  EXPECT_EQ(told_of(dashes), Lines{"2 xml-double-hyphen-in-comment"});
  EXPECT_EQ(told_of("<!-- rigor: file-ignore[xml] -->\n" + dashes), Lines{});
}

TEST(Suppression, OfAnErrorClearsTheIncluder) {
  const std::string including = model_of("<include><uri>b.sdf</uri></include>\n");
  const std::string bad = model_of(kBadPose);
  const std::string covered =
      model_of(std::string("<!-- rigor: ignore[value-malformed] -->") + kBadPose);
  EXPECT_EQ(told_of(DiskFiles{{"a.sdf", including}, {"b.sdf", bad}}),
            Lines{"2 include-has-errors"});
  EXPECT_EQ(told_of(DiskFiles{{"a.sdf", including}, {"b.sdf", covered}}), Lines{});
  const std::string bearing = model_of(
      "<!-- rigor: ignore[include-has-errors] theirs --><include><uri>b.sdf</uri></include>\n");
  EXPECT_EQ(told_of(DiskFiles{{"a.sdf", bearing}, {"b.sdf", bad}}), Lines{});
  EXPECT_EQ(told_of(DiskFiles{{"a.sdf", bearing}, {"b.sdf", covered}}),
            Lines{"2 unused-suppression"});
}

TEST(UnusedSuppression, IsNotToldOfRulesThatDidNotRun) {
  const std::string text =
      model_of("<!-- rigor: ignore[axis-zero, unknown-element, schema] -->\n<link name='a'/>\n");
  const auto told = [&](Selection selection) {
    return told_of(DiskFiles{{"a.sdf", text}}, {.selection = std::move(selection)}).size();
  };
  EXPECT_EQ(told({}), 3U);
  EXPECT_EQ(told({.ignore = {"axis-zero"}}), 2U);
  EXPECT_EQ(told({.ignore = {"unknown-element"}}), 1U);  // nor can it be told of its category
  EXPECT_EQ(told({.select = {"suppression"}}), 0U);
  EXPECT_EQ(told({.select = {"suppression", "kinematics"}}), 1U);
}

TEST(UnusedSuppression, IsNotToldOfWhatOtherCommandsFind) {
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[convert, convert-loop, simulate, simulate-tips, "
                             "mesh, mesh-not-watertight] -->\n<link name='a'/>\n")),
            Lines{});
}

TEST(UnusedSuppression, IsNotToldOfInertiasWhenMeshesAreNotOpened) {
  const std::string text =
      model_of("<!-- rigor: ignore[inertia-geometry-mismatch] -->\n<link name='a'/>\n");
  EXPECT_EQ(told_of(text), Lines{"2 unused-suppression"});
  const Registry registry;
  const Runner runner(registry, {});
  const Suppressions suppressions(xml::parse(text, SourceId{0}));
  EXPECT_EQ(suppressions.facts(registry, runner, MeshPolicy::kOpen).size(), 1U);
  EXPECT_EQ(suppressions.facts(registry, runner, MeshPolicy::kDoNotOpen).size(), 0U);
  // A mesh that cannot be read encloses nothing that could be compared.
  const std::string lost =
      "<visual name='v'><geometry><mesh><uri>no.stl</uri></mesh></geometry></visual>";
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore[inertia-geometry-mismatch] -->\n<link name='a'>" +
                             lost + "</link>\n")),
            Lines{"3 mesh-not-found"});
}

TEST(ManySuppressed, FoldedFindingsAreHiddenOnlyByWhatCoversThemAll) {
  // 1,000 of a rule are listed; where the others stand is not known.
  std::string elements;
  for (int i = 0; i < 1200; ++i) elements += "<zz" + std::to_string(i) + "/>";
  const std::string link = "<link name='a'>" + elements + "</link>\n";
  const std::string name = "[unknown-element] -->";
  EXPECT_EQ(told_of("<!-- rigor: file-ignore" + name + model_of(link)), Lines{});
  EXPECT_EQ(told_of("<!-- rigor: ignore" + name + model_of(link)), Lines{});
  EXPECT_EQ(told_of(model_of("<!-- rigor: ignore" + name + link + "<zz/>")),
            Lines{"2 unknown-element"});
}

/// Applies all fixes of a rule at once.
std::string fixed_once(const std::string& text, std::string_view rule) {
  const MemoryDisk disk(DiskFiles{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
  std::vector<Edit> edits;
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule == rule && !found.fixes.empty()) append(edits, found.fixes.front().edits);
  }
  const auto fixed = apply_edits(text, edits);
  return fixed ? *fixed : "edits overlap";
}

std::string without_unused(const std::string& text) {
  return fixed_once(text, "unused-suppression");
}

TEST(UnusedSuppression, TakesAnyChoiceOfNamesOut) {
  // Names that are used stay, in their order; `unknown-element` and `value-malformed` are, and their category.
  const std::vector<std::pair<std::string, bool>> pool{
      {"axis-zero", false},      {"unknown-element", true}, {"joint-limit-inverted", false},
      {"value-malformed", true}, {"kinematics", false},     {"schema", true}};
  for (unsigned chosen = 1; chosen < 1U << pool.size(); ++chosen) {
    std::string before;
    std::string after;
    for (std::size_t i = 0; i < pool.size(); ++i) {
      if ((chosen >> i & 1U) == 0) continue;
      before += (before.empty() ? "" : ", ") + pool[i].first;
      if (pool[i].second) after += (after.empty() ? "" : ", ") + pool[i].first;
    }
    const std::string rest = std::string("<link name='a'><zz/>") + kBadPose + "</link>\n";
    const auto text = [&](const std::string& names) {
      return model_of((names.empty() ? "" : "  <!-- rigor: ignore[" + names + "] why -->\n") +
                      rest);
    };
    EXPECT_EQ(without_unused(text(before)), text(after)) << before;
  }
}

TEST(UnusedSuppression, GoesWithItsLines) {
  const std::string dead = "<!-- rigor: ignore[axis-zero] -->";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"\t" + dead + "\n<pose/>\n", "<pose/>\n"},
      {"\r\n  " + dead + " \t\r\n<pose/>\r\n", "\r\n<pose/>\r\n"},
      {"  " + dead + "  <pose/>\n", "  <pose/>\n"},
      {"<pose/>  " + dead + " \n", "<pose/>\n"},
      {"<pose/> " + dead + " <frame name='f'/>\n", "<pose/>  <frame name='f'/>\n"},
      {"<!-- rigor: ignore[axis-zero]\n because\n -->\n<pose/>\n", "<pose/>\n"},
      {dead + "\n" + dead + "\n<pose/>\n", "<pose/>\n"},
      {"  " + dead + " " + dead + "\n<pose/>\n", "  \n<pose/>\n"},
  };
  for (const auto& [before, after] : cases) {
    EXPECT_EQ(without_unused(model_of(before)), model_of(after)) << before;
  }
  EXPECT_EQ(without_unused(dead + "\n" + model_of("")), model_of(""));
  EXPECT_EQ(without_unused("\xEF\xBB\xBF" + dead + "\n" + model_of("")),
            "\xEF\xBB\xBF" + model_of(""));
  EXPECT_EQ(without_unused(model_of("") + dead), model_of(""));
}

TEST(UnusedSuppression, IsNotTakenOutOfAText) {
  // Without the comment it would read 0.56 instead of 0.5.
  const std::string text = model_of(
      "<link name='a'><inertial><mass>0.5<!-- rigor: ignore[axis-zero] "
      "-->6</mass></inertial></link>");
  EXPECT_EQ(without_unused(text), text);
}

TEST(ManySuppressions, CostNoMoreThanTheyAre) {
  // Each finding meets the one cover of its name, however many comments there are.
  std::string text = "<sdf version='1.9'>";
  constexpr int kElements = 20'000;
  for (int i = 0; i < kElements; ++i) {
    for (int k = 0; k < 5; ++k) text += "<!-- rigor: ignore[unknown-element] -->";
    text += "<zz/>";
  }
  text += "</sdf>";
  Sources sources;
  const SourceId source = sources.add("a.sdf", text);
  const xml::Document document = xml::parse(sources.bytes(source), source);
  Suppressions suppressions(document);
  Diagnostics found;
  for (const xml::Element element : document.root()->children()) {
    found.add({.rule = "unknown-element", .category = "schema", .where = element.tag_span()});
  }
  EXPECT_EQ(suppressions.uncovered(std::move(found)).list().size(), 0U);
  EXPECT_EQ(suppressions.comparisons(), static_cast<std::size_t>(kElements));
  const Registry registry;
  const SuppressionFacts facts = suppressions.facts(registry, Runner(registry, {}));
  EXPECT_EQ(facts.size(), 4U * kElements);  // said five times, needed once
}

TEST(ManySuppressions, ThatAreNestedCostTheirDepth) {
  std::string open;
  std::string close;
  for (int i = 0; i < 90; ++i) {
    open += "<!-- rigor: ignore[axis-zero] --><a>";
    close += "</a>";
  }
  std::string wide;
  for (int i = 0; i < 1000; ++i) wide += "<!-- rigor: ignore[axis-zero] --><b/>";
  Sources sources;
  const SourceId source = sources.add("a.sdf", "<sdf>" + open + wide + "<c/>" + close + "</sdf>");
  const xml::Document document = xml::parse(sources.bytes(source), source);
  Suppressions suppressions(document);
  Diagnostics found;
  found.add({.rule = "axis-zero",
             .category = "kinematics",
             .where = document.element(document.element_count() - 1).tag_span()});
  EXPECT_TRUE(suppressions.uncovered(std::move(found)).list().empty());
  EXPECT_LE(suppressions.comparisons(), 91U);  // the last <b/>, and what is around <c/>
}

TEST(ManySuppressions, OfManyNamesInOneComment) {
  std::string names;
  for (int i = 0; i < 10'000; ++i) names += "no-rule-" + std::to_string(i) + ",";
  const MemoryDisk disk(DiskFiles{
      {"a.sdf", model_of("<!-- rigor: ignore[" + names + "unknown-element] -->\n<zz/>\n")}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found = validate(environment, {.paths = {"a.sdf"}}, sources).diagnostics;
  EXPECT_EQ(found.count(Severity::kWarning), 10'000U);
  EXPECT_EQ(found.list().size(), 1001U);
}

}  // namespace
}  // namespace rigor::rules
