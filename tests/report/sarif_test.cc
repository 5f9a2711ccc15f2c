// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/sarif/sarif.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/found.h>
#include <rigor/report/tool.h>
#include <rigor/rules/environment.h>

namespace rigor::report {
namespace {

using SarifJson = nlohmann::ordered_json;

SarifJson sarif_of(const Found& found) { return SarifJson::parse(sarif(found.validation())); }

SarifJson only_result(const Found& found) { return sarif_of(found)["runs"][0]["results"].at(0); }

/// What a path leads to: names separated by dots, `[]` for each item of a list.
std::vector<SarifJson> values_at(const SarifJson& from, const std::string& path) {
  std::vector<SarifJson> values = {from};
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    std::string name = path.substr(begin, end - begin);
    const bool each = name.ends_with("[]");
    if (each) name.resize(name.size() - 2);
    std::vector<SarifJson> next;
    for (const SarifJson& value : values) {
      EXPECT_TRUE(value.is_object() && value.contains(name)) << path << ": no " << name;
      if (!value.is_object() || !value.contains(name)) continue;
      if (each) {
        EXPECT_TRUE(value[name].is_array()) << path;
        next.insert(next.end(), value[name].begin(), value[name].end());
      } else {
        next.push_back(value[name]);
      }
    }
    values = std::move(next);
    begin = end + 1;
  }
  return values;
}

/// What GitHub's "SARIF support for code scanning" requires, and the text lengths it takes.
struct RequiredField {
  const char* path;
  std::size_t most = 0;  ///< characters of a text; 0 for what is no text
};
constexpr RequiredField kRequired[] = {
    {"$schema", 1024},
    {"version", 1024},
    {"runs[].tool.driver.name", 1024},
    {"runs[].tool.driver.semanticVersion", 1024},
    {"runs[].tool.driver.rules[].id", 255},
    {"runs[].tool.driver.rules[].name", 255},
    {"runs[].tool.driver.rules[].shortDescription.text", 1024},
    {"runs[].tool.driver.rules[].fullDescription.text", 1024},
    {"runs[].tool.driver.rules[].help.text", 100'000},
    {"runs[].tool.driver.rules[].help.markdown", 100'000},
    {"runs[].tool.driver.rules[].defaultConfiguration.level", 10},
    {"runs[].tool.driver.rules[].properties.tags[]", 255},
    {"runs[].columnKind", 100},
    {"runs[].invocations[].executionSuccessful", 0},
    {"runs[].invocations[].exitCode", 0},
    {"runs[].originalUriBaseIds.SRCROOT", 0},
    {"runs[].results[].ruleId", 255},
    {"runs[].results[].ruleIndex", 0},
    {"runs[].results[].level", 10},
    {"runs[].results[].message.text", 100'000},
    {"runs[].results[].locations[].physicalLocation.artifactLocation.uri", 10'000},
    {"runs[].results[].locations[].physicalLocation.artifactLocation.uriBaseId", 100},
    {"runs[].results[].locations[].physicalLocation.region.startLine", 0},
    {"runs[].results[].locations[].physicalLocation.region.startColumn", 0},
    {"runs[].results[].locations[].physicalLocation.region.endLine", 0},
    {"runs[].results[].locations[].physicalLocation.region.endColumn", 0},
    {"runs[].results[].partialFingerprints.primaryLocationLineHash", 100},
    {"runs[].results[].partialFingerprints.rigorId/v2", 100},
};

TEST(Sarif, HasEveryFieldThatCodeScanningRequires) {
  MemoryDisk disk;
  disk.put("arm.sdf", R"(<sdf version="1.9"><model name="arm">
<link name="a"/><link name="a"/>
<joint name="j" type="revolute"><parent>a</parent><child>b</child>
<axis><xyz>0 0 0</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis></joint>
</model></sdf>)");
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, {.paths = {"arm.sdf"}}, sources);
  const SarifJson log = SarifJson::parse(sarif({result, sources, environment.registry}));
  ASSERT_GE(log["runs"][0]["results"].size(), 4U);
  for (const RequiredField& field : kRequired) {
    const std::vector<SarifJson> values = values_at(log, field.path);
    EXPECT_FALSE(values.empty()) << field.path;
    for (const SarifJson& value : values) {
      if (field.most == 0) continue;
      ASSERT_TRUE(value.is_string()) << field.path;
      EXPECT_FALSE(value.get<std::string>().empty()) << field.path;
      EXPECT_LE(value.get<std::string>().size(), field.most) << field.path;
    }
  }
  const SarifJson& rules = log["runs"][0]["tool"]["driver"]["rules"];
  for (const SarifJson& one : log["runs"][0]["results"]) {
    EXPECT_EQ(rules.at(one["ruleIndex"].get<std::size_t>())["id"], one["ruleId"]);
  }
}

TEST(Sarif, KnowsEveryRuleThatLooksAtFiles) {
  const SarifJson rules = sarif_of(Found())["runs"][0]["tool"]["driver"]["rules"];
  std::vector<std::string> ids;
  for (const SarifJson& rule : rules) {
    ids.push_back(rule["id"]);
    const std::set<std::string> levels = {"error", "warning", "note"};
    const std::set<std::string> severities = {"error", "warning", "recommendation"};
    EXPECT_TRUE(levels.contains(rule["defaultConfiguration"]["level"])) << rule["id"];
    EXPECT_TRUE(severities.contains(rule["properties"]["problem.severity"])) << rule["id"];
  }
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  const auto has = [&ids](const char* id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  EXPECT_TRUE(has("axis-zero") && has("xml-not-well-formed") && has("mesh-not-found"));
  const rules::Registry registry;
  for (const rules::Rule& rule : registry.rules()) {
    const bool other =
        rule.category == rules::Category::kConvert || rule.category == rules::Category::kSimulate;
    EXPECT_EQ(has(std::string(rule.name).c_str()), !other) << rule.name;
  }
  const auto axis_zero = std::find(ids.begin(), ids.end(), "axis-zero") - ids.begin();
  EXPECT_EQ(rules[static_cast<std::size_t>(axis_zero)]["name"], "AxisZero");
}

TEST(Sarif, AResultWithItsPlace) {
  Found found;
  found.folders = {"/ci/repo/robots", "/ci/repo"};
  found.exit_code = 1;
  found.file("a #1,ä.sdf", "<ä>\n <xyz>0 0 0</xyz>")
      .at("0 0 0", {.message = "the axis is 0 0 0", .subject = "arm/joint elbow"});
  const SarifJson run = sarif_of(found)["runs"][0];
  const SarifJson& result = run["results"][0];
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["message"]["text"], "the axis is 0 0 0.");
  const SarifJson& location = result["locations"][0];
  EXPECT_EQ(location["physicalLocation"]["artifactLocation"]["uri"],
            "robots/a%20%231%2C%C3%A4.sdf");
  EXPECT_EQ(location["physicalLocation"]["artifactLocation"]["uriBaseId"], "SRCROOT");
  EXPECT_EQ(location["physicalLocation"]["region"],
            (SarifJson{{"startLine", 2}, {"startColumn", 7}, {"endLine", 2}, {"endColumn", 12}}));
  EXPECT_EQ(location["logicalLocations"][0]["fullyQualifiedName"], "arm/joint elbow");
  EXPECT_EQ(run["invocations"][0]["executionSuccessful"], true);
  EXPECT_EQ(run["invocations"][0]["exitCode"], 1);
  EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
  EXPECT_EQ(run["artifacts"][0]["location"]["uri"], "robots/a%20%231%2C%C3%A4.sdf");
}

// The lines and hashes of codeql-action's own tests.
TEST(Sarif, TheLineHashIsThatOfTheLine) {
  Found found;
  found.file("a.sdf", " a\nb\n  \t\tc\n d").at("c", {.message = "it"});
  EXPECT_EQ(only_result(found)["partialFingerprints"]["primaryLocationLineHash"],
            "180aee12dab6264:1");
}

TEST(Sarif, WithoutATextOnlyTheArtifact) {
  Found found;
  found.file("a.sdf", "x").add({.message = "no triangles", .path = "meshes/wheel.stl"});
  const SarifJson result = only_result(found);
  const SarifJson& physical = result["locations"][0]["physicalLocation"];
  EXPECT_EQ(physical["artifactLocation"]["uri"], "meshes/wheel.stl");
  EXPECT_FALSE(physical.contains("region"));
  EXPECT_FALSE(result["partialFingerprints"].contains("primaryLocationLineHash"));
  EXPECT_FALSE(result["locations"][0].contains("logicalLocations"));
}

TEST(Sarif, APlaceBetweenCharactersMarksOne) {
  Found found;
  found.file("a.sdf", "ab").at("b", {.message = "it"});
  Found empty;
  empty.file("a.sdf", "ab");
  Span between = empty.span_of("b");
  between.end = between.begin;
  empty.add({.message = "it", .where = between});
  EXPECT_EQ(only_result(empty)["locations"], only_result(found)["locations"]);
}

TEST(Sarif, LevelsAreThoseOfTheFindings) {
  Found found;
  found.file("a.sdf", "x")
      .at("x", {.severity = Severity::kInfo})
      .at("x", {.severity = Severity::kWarning});
  const SarifJson results = sarif_of(found)["runs"][0]["results"];
  EXPECT_EQ(results[0]["level"], "note");
  EXPECT_EQ(results[1]["level"], "warning");
}

TEST(Sarif, RelatedPlacesAreLinkedFromTheMessage) {
  Found found;
  found.file("a.sdf", "x\ny\n");
  Diagnostic diagnostic{.message = "a second 'l[0](1)'", .help = "rename one"};
  diagnostic.related = {{found.span_of("y"), "the [first]"}, {{}, "said elsewhere"}};
  found.at("x", diagnostic);
  const SarifJson result = only_result(found);
  EXPECT_EQ(result["message"]["text"],
            "a second 'l[0] (1)'. [the \\[first\\]](1). said elsewhere. Help: rename one.");
  ASSERT_EQ(result["relatedLocations"].size(), 1U);
  EXPECT_EQ(result["relatedLocations"][0]["id"], 1);
  EXPECT_EQ(result["relatedLocations"][0]["message"]["text"], "the [first]");
  EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["region"]["startLine"], 2);
}

TEST(Sarif, SaysNothingOfTheMachine) {
  Found found;
  found.folders = {"/home/me/robots", "/home/me/robots"};
  found.file("/home/me/robots/a.sdf", "x")
      .at("x", {.message = "not found", .help = "tried /home/me/.gazebo/models/x (a default)"});
  EXPECT_EQ(sarif(found.validation()).find("/home/me"), std::string::npos);
}

TEST(Sarif, AFixReplacesRegions) {
  Found found;
  found.file("a.sdf", "<ä>1</ä>\n<b>-1</b>");
  Span before_b = found.span_of("<b>");
  before_b.end = before_b.begin;
  Diagnostic diagnostic{.message = "it"};
  diagnostic.fixes = {{"swap them",
                       Applicability::kUnsafe,
                       {{found.span_of("1"), "-1"}, {found.span_of("-1"), ""}, {before_b, " "}}}};
  found.at("1", diagnostic);
  const SarifJson fix = only_result(found)["fixes"][0];
  EXPECT_EQ(fix["description"]["text"], "swap them");
  EXPECT_EQ(fix["properties"]["applicability"], "unsafe");
  ASSERT_EQ(fix["artifactChanges"].size(), 1U);
  const SarifJson& replacements = fix["artifactChanges"][0]["replacements"];
  EXPECT_EQ(replacements[0]["deletedRegion"],
            (SarifJson{{"startLine", 1}, {"startColumn", 4}, {"endLine", 1}, {"endColumn", 5}}));
  EXPECT_EQ(replacements[0]["insertedContent"]["text"], "-1");
  EXPECT_FALSE(replacements[1].contains("insertedContent"));
  EXPECT_EQ(replacements[2]["deletedRegion"],
            (SarifJson{{"startLine", 2}, {"startColumn", 1}, {"endLine", 2}, {"endColumn", 1}}));
}

TEST(Sarif, SaysWhatWasNotLookedAt) {
  Found found;
  found.exit_code = 2;
  found.result.not_looked_at = {{"t.sdf.erb", "template: expand it first"}};
  found.result.unusable = {"nowhere: no such file or folder"};
  const SarifJson invocation = sarif_of(found)["runs"][0]["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], false);
  const SarifJson& left = invocation["toolExecutionNotifications"][0];
  EXPECT_EQ(left["message"]["text"], "not looked at: template: expand it first");
  EXPECT_EQ(left["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "t.sdf.erb");
  EXPECT_EQ(invocation["toolConfigurationNotifications"][0]["message"]["text"],
            "nowhere: no such file or folder");
}

TEST(Sarif, ACleanRunHasResultsThatAreNone) {
  const SarifJson run = sarif_of(Found())["runs"][0];
  EXPECT_EQ(run["results"], SarifJson::array());
  EXPECT_EQ(run["tool"]["driver"]["semanticVersion"], tool_version());
}

}  // namespace
}  // namespace rigor::report
