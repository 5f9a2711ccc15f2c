// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs every example of every rule, so that what `rigor explain` shows is true.

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/author/simulation.h>
#include <rigor/config/scenario.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/example.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/validate.h>
#include <rigor/text/edit.h>

namespace rigor::rules {
namespace {

struct Checked {
  Sources sources;
  ValidateResult result;
};

/// Of the rules on MJCF, those that a conversion to URDF breaks.
constexpr std::string_view kFromMjcfToUrdf[] = {"convert-from-mjcf-loop", "convert-from-mjcf-root",
                                                "convert-from-mjcf-free",
                                                "convert-from-mjcf-world"};

/// Converts a model to the other format, or to MJCF for a rule on that.
Diagnostics converted(const Environment& environment, const Rule& rule, const std::string& path,
                      Sources& sources) {
  read::Workspace workspace(environment.disk, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = read::load(reader, workspace.open(path));
  const author::ConversionOptions options{.out = "out/" + path};
  if (rule.name.starts_with("convert-mjcf-")) {
    return author::to_mjcf(environment, sources, workspace, loaded, {}, options).diagnostics;
  }
  if (loaded.root.format == model::Format::kMjcf) {
    const bool urdf = std::find(std::begin(kFromMjcfToUrdf), std::end(kFromMjcfToUrdf),
                                rule.name) != std::end(kFromMjcfToUrdf);
    const auto convert = urdf ? author::from_mjcf_to_urdf : author::from_mjcf_to_sdf;
    return convert(environment, sources, workspace, loaded, {}, options).diagnostics;
  }
  if (loaded.root.format == model::Format::kUrdf) {
    return author::to_sdf(environment, sources, workspace, loaded, {}, options).diagnostics;
  }
  return author::to_urdf(environment, sources, workspace, loaded, {}, options).diagnostics;
}

/// What an example is put through: the tests named in the comment of its first line, and the scenarios
/// beside it. When it says nothing, what the rule's bad example is put through; else it settles.
simulate::Plan plan_of(const Rule& rule, const ParsedExample& example) {
  simulate::Plan plan;
  const std::string& bytes = example.files.front().bytes;
  const std::string line = bytes.substr(0, bytes.find('\n'));
  std::smatch named;
  if (std::regex_match(line, named, std::regex("<!-- rigor simulate.* --test ([^ ]+) -->"))) {
    std::istringstream tests(named[1]);
    for (std::string test; std::getline(tests, test, ',');) plan.tests.push_back(test);
  }
  for (const ParsedExample::File& file : example.files) {
    if (!file.path.ends_with(".scenario.toml")) continue;
    plan.scenarios.push_back(config::read_scenario(file.path, file.bytes));
    EXPECT_TRUE(plan.scenarios.back().problems.empty());
  }
  if (!plan.tests.empty() || !plan.scenarios.empty()) return plan;
  const ParsedExample bad = parse_example(examples_of(rule).bad.front().text);
  if (bad.files.front().bytes != bytes) return plan_of(rule, bad);
  plan.tests.emplace_back("settle");
  return plan;
}

/// An example whose first line says so is simulated in both engines.
std::vector<simulate::EngineKind> engines_of(const Rule& rule, const ParsedExample& example) {
  const ParsedExample bad = parse_example(examples_of(rule).bad.front().text);
  for (const ParsedExample* each : {&example, &bad}) {
    if (each->files.front().bytes.starts_with("<!-- rigor simulate --engine both ")) {
      return {simulate::EngineKind::kOde, simulate::EngineKind::kMujoco};
    }
  }
  return {simulate::EngineKind::kOde};
}

/// Simulates an example, as `rigor simulate` does. Causes go into the findings that they explain: they
/// are asked for once more on their own.
Diagnostics simulated(const Environment& environment, const Rule& rule,
                      const ParsedExample& example, Sources& sources) {
  read::Workspace workspace(environment.disk, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const author::Simulator simulator(
      environment, sources, workspace,
      {.plan = plan_of(rule, example), .engines = engines_of(rule, example)});
  const read::Loaded loaded =
      read::load(reader, workspace.open(example_path(example.files.front())));
  const author::PreparedModel model = simulator.prepare(loaded, {});
  author::SimulatedModel result = std::move(simulator.run({{&model, {}}}).front());
  EXPECT_TRUE(result.left_out.empty() && result.problems.empty());
  const Runner runner(environment.registry, {.select = {"simulate"}});
  for (Diagnostics& said : runner.run_each(environment, sources, loaded, model.causes)) {
    result.diagnostics.take(std::move(said));
  }
  return std::move(result.diagnostics);
}

/// Checks an example's first file, with its other files beside it; for a rule on conversions, converts
/// it; for one on simulations, simulates it.
void check(const Rule& rule, const ParsedExample& example, Checked& checked) {
  MemoryDisk disk;
  for (const ParsedExample::File& file : example.files) disk.put(example_path(file), file.bytes);
  const Environment environment(disk, {});
  const std::string path = example_path(example.files.front());
  if (rule.category == Category::kConvert) {
    checked.result.diagnostics = converted(environment, rule, path, checked.sources);
  } else if (rule.category == Category::kSimulate) {
    checked.result.diagnostics = simulated(environment, rule, example, checked.sources);
  } else {
    checked.result = validate(environment,
                              {.paths = {path},
                               .argument_sets = ArgumentSets::kAll,
                               .selection = {.targets = rule.targets}},
                              checked.sources);
  }
}

std::string describe(const Checked& checked, const Diagnostic& diagnostic) {
  std::string text = std::string(diagnostic.rule) + ": " + diagnostic.message;
  if (!diagnostic.where.nowhere()) {
    text += " at '" + std::string(checked.sources.bytes(diagnostic.where)) + "'";
  }
  return text;
}

/// Whether a finding is in a file that a template of the example includes or loads.
bool is_beside(const Checked& checked, const Diagnostic& diagnostic) {
  if (diagnostic.where.nowhere()) return false;
  const std::string_view path = checked.sources.path(diagnostic.where.source);
  return checked.result.files.size() == 1 && checked.result.files[0].path.ends_with(".xacro") &&
         path != checked.result.files[0].path;
}

using Marks = std::vector<ParsedExample::Marked>;

Marks places(const Checked& checked, const Rule& rule) {
  Marks marks;
  for (const Diagnostic& diagnostic : checked.result.diagnostics.list()) {
    if (diagnostic.rule != rule.name || is_beside(checked, diagnostic)) continue;
    marks.push_back({diagnostic.where.begin, diagnostic.where.end});
  }
  const auto before = [](const auto& a, const auto& b) { return a.begin < b.begin; };
  std::sort(marks.begin(), marks.end(), before);
  if (rule.category == Category::kSimulate) {  // several tests, or metrics, may show the same
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  }
  return marks;
}

class EveryRule : public testing::TestWithParam<const Rule*> {};

const Registry& registry() {
  static const Registry kRegistry;
  return kRegistry;
}

std::vector<const Rule*> all_rules() {
  std::vector<const Rule*> rules;
  for (const Rule& rule : registry().rules()) rules.push_back(&rule);
  return rules;
}

TEST_P(EveryRule, ReportsItsBadExamplesWhereTheyAreMarked) {
  const Rule& rule = *GetParam();
  for (const Example& example : examples_of(rule).bad) {
    SCOPED_TRACE(example.text);
    const ParsedExample parsed = parse_example(example.text);
    Checked checked;
    check(rule, parsed, checked);
    const Marks expected = parsed.marked;
    const Marks found = places(checked, rule);
    const auto& list = checked.result.diagnostics.list();
    const bool is_said = std::any_of(
        list.begin(), list.end(), [&rule](const Diagnostic& one) { return one.rule == rule.name; });
    if (expected.empty()) {
      EXPECT_TRUE(is_said) << "the rule says nothing of its own bad example";
    } else {
      EXPECT_EQ(found, expected);
    }
    for (const Diagnostic& diagnostic : checked.result.diagnostics.list()) {
      const bool own = diagnostic.rule == rule.name;
      // What tips over does not settle either.
      const bool alone = rule.category != Category::kSimulate;
      if (!own && alone && diagnostic.severity == Severity::kError) {
        ADD_FAILURE() << "one fault, two errors: " << describe(checked, diagnostic);
      }
      const bool elsewhere =
          found != expected && !diagnostic.where.nowhere() && !is_beside(checked, diagnostic);
      if (own && elsewhere) ADD_FAILURE() << describe(checked, diagnostic);
      EXPECT_FALSE(diagnostic.message.ends_with('.')) << diagnostic.message;
    }
  }
}

TEST_P(EveryRule, IsSilentOnItsGoodExamples) {
  const Rule& rule = *GetParam();
  for (const Example& example : examples_of(rule).good) {
    SCOPED_TRACE(example.text);
    Checked checked;
    check(rule, parse_example(example.text), checked);
    for (const Diagnostic& diagnostic : checked.result.diagnostics.list()) {
      if (diagnostic.rule == rule.name || diagnostic.severity == Severity::kError) {
        ADD_FAILURE() << describe(checked, diagnostic);
      }
    }
  }
}

TEST_P(EveryRule, FixesWhatItSaysItFixes) {
  const Rule& rule = *GetParam();
  if (rule.category == Category::kSimulate) {  // a run has no edits to offer
    EXPECT_EQ(rule.fix, FixGrade::kNone);
    return;
  }
  for (const Example& example : examples_of(rule).bad) {
    SCOPED_TRACE(example.text);
    const ParsedExample parsed = parse_example(example.text);
    Checked checked;
    check(rule, parsed, checked);
    std::vector<Edit> edits;
    for (const Diagnostic& diagnostic : checked.result.diagnostics.list()) {
      if (diagnostic.rule != rule.name || diagnostic.fixes.empty()) continue;
      const Fix& fix = diagnostic.fixes.front();
      EXPECT_EQ(fix.applicability == Applicability::kSafe, rule.fix == FixGrade::kSafe);
      edits.insert(edits.end(), fix.edits.begin(), fix.edits.end());
    }
    if (example.fixed.empty()) continue;
    const auto fixed = apply_edits(parsed.files.front().bytes, edits);
    ASSERT_TRUE(fixed);
    EXPECT_EQ(*fixed, example.fixed);
    // What was put right stays right.
    ParsedExample again = parsed;
    again.files.front().bytes = *fixed;
    Checked rechecked;
    check(rule, again, rechecked);
    EXPECT_TRUE(places(rechecked, rule).empty());
  }
}

TEST_P(EveryRule, SaysWhatItIsAbout) {
  const Rule& rule = *GetParam();
  EXPECT_TRUE(std::regex_match(std::string(rule.name), std::regex("[a-z0-9]+(-[a-z0-9]+)*")));
  EXPECT_FALSE(rule.summary.empty());
  EXPECT_GE(rule.why.size(), 40U);
  EXPECT_GE(rule.what_to_do.size(), 15U);
  EXPECT_FALSE(rule.checks.empty());
  for (const std::string_view text : {rule.summary, rule.why, rule.what_to_do}) {
    EXPECT_EQ(text.find("TODO"), std::string_view::npos);
  }
  const std::vector<Example> bad_ones = examples_of(rule).bad;
  const bool has_fixed = std::any_of(bad_ones.begin(), bad_ones.end(),
                                     [](const Example& bad) { return !bad.fixed.empty(); });
  EXPECT_EQ(has_fixed, rule.fix != FixGrade::kNone) << "a fix is shown where there is one";
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryRule, testing::ValuesIn(all_rules()),
                         [](const auto& instance) {
                           std::string name(instance.param->name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Registry, HasEachNameOnceAndFindsIt) {
  std::set<std::string_view> names;
  for (const Rule& rule : registry().rules()) {
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_EQ(registry().find(rule.name), &rule);
  }
  EXPECT_EQ(registry().find("no-such-rule"), nullptr);
}

TEST(Selection, ChoosesByNameAndCategory) {
  MemoryDisk disk;
  disk.put("a.sdf",
           "<sdf version='1.9'><model name='m'><static>1</static><link name='a'/><link name='b'/>"
           "<joint name='j' type='revolute'><parent>a</parent><child>b</child>"
           "<axis><xyz>0 0 0</xyz></axis></joint></model></sdf>");
  const Environment environment(disk, {});
  Sources sources;
  const auto errors = [&](Selection selection) {
    return validate(environment, {.paths = {"a.sdf"}, .selection = std::move(selection)}, sources)
        .diagnostics.count(Severity::kError);
  };
  EXPECT_EQ(errors({}), 1U);
  EXPECT_EQ(errors({.select = {"inertia"}}), 0U);
  EXPECT_EQ(errors({.select = {"kinematics"}}), 1U);
  EXPECT_EQ(errors({.ignore = {"axis-zero"}}), 0U);
  EXPECT_EQ(errors({.severity = {{"axis-zero", Severity::kInfo}}}), 0U);
  EXPECT_EQ(unknown_name({.select = {"mesh", "mseh"}}, environment.registry), "mseh");
}

}  // namespace
}  // namespace rigor::rules
