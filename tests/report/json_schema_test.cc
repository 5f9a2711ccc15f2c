// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The published shape of the JSON report, docs/schemas/validate.schema.json, against what is printed: nothing is
// missing, and nothing is there that it does not tell of.

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <report/found.h>
#include <rigor/report/json/json.h>
#include <rigor/report/jsonl.h>
#include <rigor/rules/environment.h>
#include <support/corpus.h>

namespace rigor::report {
namespace {

using SchemaJson = nlohmann::json;

/// As much of JSON Schema 2020-12 as the schema uses; any other keyword is a failure.
class SchemaChecker {
 public:
  explicit SchemaChecker(SchemaJson schema) : schema_(std::move(schema)) {}

  /// What is wrong with a document; empty when it conforms.
  std::vector<std::string> problems(const SchemaJson& document) {
    return problems(document, schema_);
  }
  std::vector<std::string> problems(const SchemaJson& document, const SchemaJson& schema) {
    problems_.clear();
    check(document, schema, "");
    return problems_;
  }
  const SchemaJson& definition(const char* name) const { return schema_["$defs"][name]; }

 private:
  void check(const SchemaJson& value, const SchemaJson& schema, const std::string& where) {
    for (const auto& [keyword, rule] : schema.items()) {
      if (keyword == "$ref") {
        const std::string name = rule.get<std::string>().substr(std::string("#/$defs/").size());
        check(value, schema_["$defs"].at(name), where);
      } else if (keyword == "type") {
        has_type(value, rule, where);
      } else if (keyword == "const") {
        if (value != rule) say(where, "is not " + rule.dump());
      } else if (keyword == "enum") {
        if (std::find(rule.begin(), rule.end(), value) == rule.end()) say(where, "is none of them");
      } else if (keyword == "minimum") {
        if (value.is_number() && value < rule) say(where, "is below " + rule.dump());
      } else if (keyword == "required") {
        for (const std::string name : rule) {
          if (value.is_object() && !value.contains(name)) say(where, "has no " + name);
        }
      } else if (keyword == "properties") {
        check_properties(value, rule, where);
      } else if (keyword == "items") {
        if (!value.is_array()) continue;
        for (std::size_t i = 0; i < value.size(); ++i) {
          check(value[i], rule, where + '/' + std::to_string(i));
        }
      } else if (!kSilent.contains(keyword)) {
        say(where, "keyword " + keyword + " is not known to this test");
      }
    }
  }

  void has_type(const SchemaJson& value, const SchemaJson& types, const std::string& where) {
    const SchemaJson all = types.is_array() ? types : SchemaJson::array({types});
    for (const std::string type : all) {
      if ((type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
          (type == "string" && value.is_string()) || (type == "null" && value.is_null()) ||
          (type == "number" && value.is_number()) ||
          (type == "integer" && value.is_number_integer())) {
        return;
      }
    }
    say(where, "is no " + all.dump());
  }

  void check_properties(const SchemaJson& value, const SchemaJson& known,
                        const std::string& where) {
    if (!value.is_object()) return;
    for (const auto& [name, item] : value.items()) {
      if (!known.contains(name)) {
        say(where, name + " is not in the schema");
      } else {
        check(item, known[name], where + '/' + name);
      }
    }
  }

  void say(const std::string& where, const std::string& what) {
    problems_.push_back(where + ": " + what);
  }

  inline static const std::set<std::string> kSilent = {"$schema", "$defs", "title", "description"};
  SchemaJson schema_;
  std::vector<std::string> problems_;
};

SchemaJson published_schema() {
  return SchemaJson::parse(
      test::read_file(std::string(RIGOR_SOURCE_DIR) + "/docs/schemas/validate.schema.json"));
}

using Problems = std::vector<std::string>;

class JsonSchema : public testing::Test {
 protected:
  JsonSchema() {
    Diagnostic with_all{.message = "it", .subject = "arm/link a", .help = "do"};
    with_all.related = {{{}, "nowhere"}};
    with_all.fixes = {{"cut", Applicability::kManual, {{{}, "x"}}}};
    found_.file("a.sdf", "x\n")
        .at("x", with_all)
        .add({.severity = Severity::kInfo, .path = "w.stl"});
    found_.file("b.sdf", "");
    found_.result.files.back().meshes = {
        {"hull.stl", "0123456789abcdef0123456789abcdef", 684, 12, {{-1, -1, -1}}, {{1, 1, 1}}},
        {"torn.stl", "0123456789abcdef0123456789abcdee", 3}};
    found_.result.not_looked_at = {{"a.sdf", "include of https://example.org/hand"}};
  }

  Found found_;
  SchemaChecker checker_{published_schema()};
};

TEST_F(JsonSchema, WhatIsPrintedConforms) {
  EXPECT_EQ(checker_.problems(SchemaJson::parse(json(found_.result, found_.sources))), Problems());
  EXPECT_EQ(checker_.problems(SchemaJson::parse(json({}, Sources()))), Problems());
}

TEST_F(JsonSchema, SoDoesEachLine) {
  const std::string lines = jsonl(found_.validation());
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < lines.size(); ++count) {
    const std::size_t end = lines.find('\n', begin);
    const SchemaJson line = SchemaJson::parse(lines.substr(begin, end - begin));
    EXPECT_EQ(checker_.problems(line, checker_.definition("line")), Problems());
    begin = end + 1;
  }
  EXPECT_EQ(count, 2U);
}

TEST_F(JsonSchema, RealFilesConform) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(
      environment, {.paths = {test::corpus()}, .meshes = rules::MeshPolicy::kDoNotOpen}, sources);
  EXPECT_GT(result.files.size(), 100U);
  EXPECT_EQ(checker_.problems(SchemaJson::parse(json(result, sources))), Problems());
}

TEST_F(JsonSchema, TheTestSeesWhatIsWrong) {
  SchemaJson document = SchemaJson::parse(json(found_.result, found_.sources));
  document["summary"].erase("errors");
  document["files"][0]["kind"] = "step";
  document["diagnostics"][0]["line"] = 0;
  document["diagnostics"][0]["path"] = nullptr;
  document["diagnostics"][1]["more"] = 1;
  EXPECT_EQ(checker_.problems(document).size(), 5U);
}

}  // namespace
}  // namespace rigor::report
