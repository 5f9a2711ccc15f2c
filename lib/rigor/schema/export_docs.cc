// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/export.h>

#include <map>

namespace rigor::schema {
namespace {

std::string count_words(Cardinality cardinality) {
  switch (cardinality) {
    case Cardinality::kOptional: return "at most one";
    case Cardinality::kOne: return "exactly one";
    case Cardinality::kMany: return "any number";
    case Cardinality::kOneOrMore: return "at least one";
    case Cardinality::kDeprecated: return "at most one, better none";
  }
  return "";
}

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string type_words(const Node& node) {
  if (node.enumeration().empty()) return std::string(to_string(node.type()));
  std::string words;
  for (const std::string_view word : node.enumeration()) {
    words += (words.empty() ? "" : ", ") + code(word);
  }
  return words;
}

std::string default_words(const Node& node) {
  const std::optional<std::string_view> value = node.default_value();
  if (!value) return "";
  return value->empty() ? "empty" : code(*value);
}

std::string bounds_words(const Node& node) {
  std::string words;
  if (node.minimum()) words += "at least " + code(*node.minimum());
  if (node.maximum()) words += (words.empty() ? "at most " : ", at most ") + code(*node.maximum());
  return words;
}

class DocsWriter {
 public:
  std::string run(const Schema& schema, const Node& root) {
    oldest_ = schema.versions().front();
    out_ = "# " + code(root.name()) + " " + to_string(root.version()) + "\n\n";
    out_ +=
        "Each section is one element. What an element may contain is listed once; later places "
        "refer "
        "to it.\n";
    write(root, std::string(root.name()));
    return out_;
  }

 private:
  void item(std::string_view label, const std::string& value) {
    if (!value.empty()) out_ += "- " + std::string(label) + ": " + value + "\n";
  }

  void write(const Node& node, const std::string& path) {
    out_ += "\n## " + path + "\n\n" + std::string(node.doc()) + "\n\n";
    item("Number", count_words(node.cardinality()));
    item(node.enumeration().empty() ? "Type" : "Values", type_words(node));
    item("Unit", std::string(node.unit()));
    item("Default", default_words(node));
    item("Bounds", bounds_words(node));
    if (node.since() > oldest_) item("Since", to_string(node.since()));
    if (node.until()) item("Until", to_string(*node.until()));
    if (node.deprecated_since()) item("Deprecated since", to_string(*node.deprecated_since()));
    if (!node.instead().empty()) item("Use instead", code(node.instead()));
    if (node.open()) item("Content", "free");
    const auto [first, is_new] = first_places_.emplace(node.declaration(), path);
    if (!is_new) {
      item("Attributes and content", "as in " + first->second);
      return;
    }
    write_attributes(node);
    for (const Node child : node.children()) write(child, path + "/" + std::string(child.name()));
  }

  void write_attributes(const Node& node) {
    if (node.attributes().empty()) return;
    out_ +=
        "\n| attribute | type | number | default | unit | meaning |\n|---|---|---|---|---|---|\n";
    for (const Node attribute : node.attributes()) {
      out_ += "| " + code(attribute.name()) + " | " + type_words(attribute) + " | " +
              count_words(attribute.cardinality()) + " | " + default_words(attribute) + " | " +
              std::string(attribute.unit()) + " | " + std::string(attribute.doc()) + " |\n";
    }
  }

  std::string out_;
  Version oldest_;
  std::map<std::uint32_t, std::string> first_places_;  // path by declaration
};

}  // namespace

std::optional<std::string> to_docs(const Schema& schema, Version version, std::string_view root) {
  const std::optional<Node> node = schema.root(root, version);
  if (!node) return std::nullopt;
  return DocsWriter().run(schema, *node);
}

}  // namespace rigor::schema
