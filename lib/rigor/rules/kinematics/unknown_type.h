// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of a type="…" that no version of the format knows.

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
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
  if (fact.node->listed_since(read::trimmed(fact.text))) return;  // value-newer-than-version
  const auto types = types_of(fact);
  const auto near = schema::near(fact.text, types);
  std::string all = "the types are";
  for (const std::string_view type : types) all += " " + std::string(type);
  const std::string element(fact.element.name());
  const auto name = fact.element.attribute("name");
  context.report({.where = fact.where,
                  .message = "'" + std::string(fact.text) + "' is no type of " + element,
                  .subject = name ? element + " " + std::string(name->value()) : element,
                  .help = near.empty() ? all : "did you mean '" + std::string(near.front()) + "'?",
                  .fix = nearest_instead(fact.text, types, fact.where)});
}

/// `type=""` is in no list, and no fact of the schema; consumers refuse it as one that they do not know.
inline void report_empty_type(const model::Site& site, std::string subject, Context& context) {
  const auto element = context.element(site);
  const auto type = element.attribute("type");
  if (!type || !read::trimmed(type->value()).empty()) return;
  context.report({.where = type->span(),
                  .message = "the type of this " + std::string(element.name()) + " is empty",
                  .subject = std::move(subject)});
}

}  // namespace rigor::rules
