// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of a type="…" that no version of the format knows.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules {

/// Whether the fact is about the type of an element of this name.
inline bool is_type_of(const read::SchemaFact& fact, std::string_view element) {
  return fact.element.name() == element && fact.attribute && fact.attribute->name() == "type" &&
         fact.node;
}

/// The types that the schema lists.
inline std::vector<std::string_view> types_of(const read::SchemaFact& fact) {
  std::vector<std::string_view> types;
  for (const std::string_view type : fact.node->enumeration()) types.push_back(type);
  return types;
}

inline void report_unknown_type(const read::SchemaFact& fact, Context& context) {
  const auto types = types_of(fact);
  const auto near = schema::near(fact.text, types);
  std::string all = "the types are";
  for (const std::string_view type : types) all += " " + std::string(type);
  const std::string element(fact.element.name());
  const auto name = fact.element.attribute("name");
  context.report(
      {.where = fact.where,
       .message = "'" + std::string(fact.text) + "' is no type of " + element,
       .subject = name ? element + " " + std::string(name->value()) : element,
       .help = near.empty() ? all : "did you mean '" + std::string(near.front()) + "'?"});
}

}  // namespace rigor::rules
