// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Generated expressions and templates against what the reference made of them: testdata/xacro, written by
// tools/xacro_answers.py.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

#include "xacro/expanded.h"

namespace rigor::test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Json> recorded(const std::string& name) {
  std::ifstream stream(RIGOR_TESTDATA "xacro/" + name);
  std::vector<Json> rows;
  for (std::string line; std::getline(stream, line);) rows.push_back(Json::parse(line));
  return rows;
}

TEST(XacroAnswers, ExpressionsMeanWhatPythonMakesOfThem) {
  const std::vector<Json> rows = recorded("expressions.jsonl");
  ASSERT_EQ(rows.size(), 401);
  std::string properties;
  for (const auto& [name, value] : rows[0]["properties"].items()) {
    properties += "<xacro:property name=\"" + name + "\" value=\"" +
                  escaped(value.get<std::string>()) + "\"/>";
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string expression = rows[i]["expression"];
    const Expanded expanded(robot(properties + "<v>${" + escaped(expression) + "}</v>"));
    if (rows[i]["value"].is_null()) {
      EXPECT_FALSE(expanded.expansion.ok()) << expression << " gives " << expanded.text();
      continue;
    }
    const xacro::Node* element = expanded.expansion.root->first_element();
    ASSERT_NE(element, nullptr) << expression;
    EXPECT_TRUE(expanded.expansion.ok()) << expression << ": " << expanded.findings()[0];
    EXPECT_EQ(element->first->text, rows[i]["value"].get<std::string>()) << expression;
  }
}

TEST(XacroAnswers, TemplatesArePrintedAsTheReferencePrintsThem) {
  const std::vector<Json> rows = recorded("templates.jsonl");
  ASSERT_EQ(rows.size(), 201);
  const std::map<std::string, std::string> files = rows[0]["files"];
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string text = rows[i]["template"];
    const Expanded expanded(text, files);
    EXPECT_EQ(expanded.expansion.ok(), !rows[i]["text"].is_null()) << text;
    if (rows[i]["text"].is_null()) continue;
    std::string expected = rows[i]["text"];
    for (int line = 0; line < 5; ++line) expected.erase(0, expected.find('\n') + 1);
    EXPECT_EQ(expanded.text(), expected) << text;
    if (!expanded.expansion.ok()) ADD_FAILURE() << expanded.findings()[0];
  }
}

}  // namespace
}  // namespace rigor::test
