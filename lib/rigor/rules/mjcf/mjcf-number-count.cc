// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::mjcf_number_count {

void check(const read::SchemaFact& fact, Context& context) {
  const std::string takes = to_string(*fact.node->count());
  context.report({.where = fact.where,
                  .message = std::string(fact.attribute->name()) + " takes " + takes + ", not " +
                             std::to_string(read::words_in(fact.text))});
}

Rule rule() {
  return {
      .name = "mjcf-number-count",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "too few or too many numbers",
      .why = "MuJoCo rejects the file: it has too few numbers, or more than the attribute takes.",
      .what_to_do = "Write as many numbers as the attribute takes.",
      .checks = {on_schema({read::SchemaFactKind::kNumberCount}, check)},
  };
}

}  // namespace rigor::rules::mjcf_number_count
