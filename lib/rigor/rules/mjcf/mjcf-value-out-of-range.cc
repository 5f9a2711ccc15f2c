// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::mjcf_value_out_of_range {

void check(const read::SchemaFact& fact, Context& context) {
  const auto least = fact.node->minimum();
  const std::string bound = least ? "not below " + std::string(*least)
                                  : "not above " + std::string(*fact.node->maximum());
  context.report({.where = fact.where,
                  .message = std::string(fact.node->name()) + " of <" +
                             std::string(fact.element.name()) + "> is " + bound});
}

Rule rule() {
  return {
      .name = "mjcf-value-out-of-range",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "value that MuJoCo does not take",
      .why = "MuJoCo rejects the file: the value is out of the bounds of its attribute.",
      .what_to_do = "Write a value within the bounds, or remove the attribute.",
      .checks = {on_schema({read::SchemaFactKind::kOutOfRange}, check)},
  };
}

}  // namespace rigor::rules::mjcf_value_out_of_range
