// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::mjcf_number_malformed {

void check(const read::SchemaFact& fact, Context& context) {
  const bool whole = fact.node->type() == schema::Type::kInt;
  const bool one = fact.node->count()->most == 1;
  const std::string wanted = one ? (whole ? "an integer" : "a number")
                                 : (whole ? "a list of integers" : "a list of numbers");
  context.report({.where = fact.where,
                  .message = "'" + std::string(fact.text) + "' of " +
                             std::string(fact.attribute->name()) + " is not " + wanted});
}

Rule rule() {
  return {
      .name = "mjcf-number-malformed",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "text where MuJoCo expects numbers",
      .why = "MuJoCo rejects the file: numbers are separated by spaces, with a point before "
             "decimals; an integer has none.",
      .what_to_do = "Write numbers, separated by spaces.",
      .checks = {on_schema({read::SchemaFactKind::kNotNumbers}, check)},
  };
}

}  // namespace rigor::rules::mjcf_number_malformed
