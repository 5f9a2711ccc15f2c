// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/json.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rigor::report {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& item : object.items()) names.push_back(item.key());
  return names;
}

using Names = std::vector<std::string>;

rules::ValidateResult example(Sources& sources) {
  const SourceId arm = sources.add("arm.sdf", "<ä\n lower='1' upper='-1'/>");
  rules::ValidateResult result;
  result.files = {{"arm.sdf", model::Format::kSdf, "1.4", 1, 3, 2},
                  {"arm.urdf", model::Format::kUrdf, "1.0", 1, 0, 0},
                  {"model.config", model::Format::kModelConfig, "", 0, 0, 0},
                  {"other.xml", model::Format::kUnknown, "", 0, 0, 0}};
  result.diagnostics.add(
      {.rule = "joint-limit-inverted",
       .category = "kinematics",
       .severity = Severity::kError,
       .message = "lower is above upper",
       .where = {arm, 12, 13},
       .subject = "arm/joint elbow",
       .related = {{{arm, 0, 3}, "in this"}, {{}, "and nowhere"}},
       .fixes = {{"swap", Applicability::kUnsafe, {{{arm, 12, 13}, "-1"}, {{arm, 22, 24}, "1"}}}}});
  result.diagnostics.add({.rule = "mesh-missing",
                          .category = "mesh",
                          .severity = Severity::kInfo,
                          .message = "byte \xFF",
                          .path = "wheel.stl"});
  result.not_looked_at = {{"arm.sdf", "include of https://example.org/hand"}};
  return result;
}

class JsonReport : public testing::Test {
 protected:
  Sources sources_;
  std::string text_ = json(example(sources_), sources_);
  Json json_ = Json::parse(text_);
};

TEST_F(JsonReport, KeysStandInTheOrderOfTheContract) {
  EXPECT_EQ(keys(json_), (Names{"tool", "schema_version", "summary", "files", "diagnostics"}));
  EXPECT_EQ(keys(json_["summary"]),
            (Names{"files", "errors", "warnings", "infos", "not_looked_at", "places"}));
  EXPECT_EQ(keys(json_["files"][0]),
            (Names{"path", "kind", "version", "models", "links", "joints"}));
  EXPECT_EQ(keys(json_["diagnostics"][0]),
            (Names{"rule", "category", "severity", "message", "path", "line", "column", "end_line",
                   "end_column", "subject", "related", "fix", "why", "help", "docs", "places",
                   "origin"}));
  EXPECT_EQ(keys(json_["diagnostics"][0]["related"][0]),
            (Names{"message", "path", "line", "column", "end_line", "end_column"}));
  EXPECT_EQ(keys(json_["diagnostics"][0]["fix"]), (Names{"title", "applicability", "edits"}));
  EXPECT_EQ(keys(json_["diagnostics"][0]["fix"]["edits"][0]), (Names{"begin", "end", "text"}));
}

TEST_F(JsonReport, IndentsByTwoAndEndsWithALineBreak) {
  EXPECT_TRUE(text_.starts_with("{\n  \"tool\": {\n    \"name\": \"rigor\",\n"));
  EXPECT_TRUE(text_.ends_with("\n}\n"));
}

TEST_F(JsonReport, Summary) {
  EXPECT_EQ(json_["schema_version"], 1);
  EXPECT_EQ(json_["summary"]["files"], 4);
  EXPECT_EQ(json_["summary"]["errors"], 1);
  EXPECT_EQ(json_["summary"]["warnings"], 0);
  EXPECT_EQ(json_["summary"]["infos"], 1);
  EXPECT_EQ(json_["summary"]["not_looked_at"], 1);
}

TEST_F(JsonReport, Files) {
  const Json& file = json_["files"][0];
  EXPECT_EQ(file["path"], "arm.sdf");
  EXPECT_EQ(file["version"], "1.4");
  EXPECT_EQ(file["models"], 1);
  EXPECT_EQ(file["links"], 3);
  EXPECT_EQ(file["joints"], 2);
  EXPECT_EQ(file["kind"], "sdf");
  EXPECT_EQ(json_["files"][1]["kind"], "urdf");
  EXPECT_EQ(json_["files"][2]["kind"], "model-config");
  EXPECT_EQ(json_["files"][3]["kind"], "unknown");
}

TEST_F(JsonReport, PositionsAreOneBasedCodePointsWithTheEndExclusive) {
  const Json& finding = json_["diagnostics"][0];
  EXPECT_EQ(finding["path"], "arm.sdf");
  EXPECT_EQ(finding["line"], 2);
  EXPECT_EQ(finding["column"], 9);
  EXPECT_EQ(finding["end_line"], 2);
  EXPECT_EQ(finding["end_column"], 10);
  EXPECT_EQ(finding["related"][0]["column"], 1);
  EXPECT_EQ(finding["related"][0]["end_column"], 3);  // `<ä` is two code points, three bytes
}

TEST_F(JsonReport, EditsAreByteOffsets) {
  const Json& fix = json_["diagnostics"][0]["fix"];
  EXPECT_EQ(fix["title"], "swap");
  EXPECT_EQ(fix["applicability"], "unsafe");
  EXPECT_EQ(fix["edits"][0]["begin"], 12);
  EXPECT_EQ(fix["edits"][0]["end"], 13);
  EXPECT_EQ(fix["edits"][0]["text"], "-1");
  EXPECT_EQ(fix["edits"].size(), 2);
}

TEST_F(JsonReport, WithoutATextPositionsAreNull) {
  const Json& finding = json_["diagnostics"][1];
  EXPECT_EQ(finding["path"], "wheel.stl");
  for (const char* key : {"line", "column", "end_line", "end_column"}) {
    EXPECT_TRUE(finding.contains(key) && finding[key].is_null()) << key;
  }
  EXPECT_TRUE(finding["fix"].is_null());
  EXPECT_EQ(finding["related"], Json::array());
  EXPECT_EQ(finding["subject"], "");
  EXPECT_TRUE(json_["diagnostics"][0]["related"][1]["line"].is_null());
}

TEST_F(JsonReport, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(json_["diagnostics"][1]["message"], "byte \uFFFD");
}

TEST(Json, EmptyRunHasEmptyLists) {
  const Json document = Json::parse(json({}, Sources()));
  EXPECT_EQ(document["files"], Json::array());
  EXPECT_EQ(document["diagnostics"], Json::array());
}

}  // namespace
}  // namespace rigor::report
