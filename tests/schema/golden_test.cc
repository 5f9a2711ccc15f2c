// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints the resolved view of every SDFormat version, one line for each element and attribute, and
// compares it with testdata/schema/sdf-1.N.txt: a change of schemas/sdf.schema shows there in all
// the versions it touches. The files are rewritten when RIGOR_REWRITE_GOLDEN is set; read the
// difference before it is committed.
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

std::string facets(const Node& node) {
  std::string out = " card=" + std::string(to_string(node.cardinality()));
  const auto add = [&out](const char* key, std::string_view value) {
    if (!value.empty()) out += std::string(" ") + key + "=" + std::string(value);
  };
  add("type", to_string(node.type()));
  if (node.default_value()) out += " default=\"" + std::string(*node.default_value()) + "\"";
  add("min", node.minimum().value_or(""));
  add("max", node.maximum().value_or(""));
  std::string words;
  for (const std::string_view word : node.enumeration()) {
    words += (words.empty() ? "" : "|") + std::string(word);
  }
  add("enum", words);
  add("unit", node.unit());
  if (node.deprecated_since()) add("deprecated", to_string(*node.deprecated_since()));
  add("instead", node.instead());
  return out + (node.open() ? " open" : "");
}

class View {
 public:
  explicit View(const Node& root) { write(root, std::string(root.name())); }
  const std::string& text() const { return text_; }

 private:
  void write(const Node& node, const std::string& path) {
    const auto [first, is_new] = first_places_.emplace(node.declaration(), path);
    text_ += path + facets(node) + (is_new ? "" : " -> " + first->second) + "\n";
    if (!is_new) return;
    for (const Node attribute : node.attributes()) {
      text_ += path + "/@" + std::string(attribute.name()) + facets(attribute) + "\n";
    }
    for (const Node child : node.children()) write(child, path + "/" + std::string(child.name()));
  }

  std::string text_;
  std::map<std::uint32_t, std::string> first_places_;  // path by declaration; ends the recursion
};

TEST(Golden, ResolvedViewOfEveryVersion) {
  auto parsed = Schema::parse(sdf_schema_text());
  ASSERT_TRUE(std::holds_alternative<Schema>(parsed));
  const Schema& schema = std::get<Schema>(parsed);
  for (const Version version : schema.versions()) {
    std::string text;
    for (const Node root : schema.roots(version)) text += View(root).text();
    const std::string path =
        std::string(RIGOR_TESTDATA) + "/schema/sdf-" + to_string(version) + ".txt";
    if (std::getenv("RIGOR_REWRITE_GOLDEN")) {
      std::ofstream(path, std::ios::binary) << text;
      continue;
    }
    std::ifstream in(path, std::ios::binary);
    ASSERT_TRUE(in) << path << " is absent; RIGOR_REWRITE_GOLDEN=1 writes it";
    std::ostringstream golden;
    golden << in.rdbuf();
    EXPECT_EQ(text, golden.str()) << path;
  }
}

}  // namespace
}  // namespace rigor::schema
