// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::mjcf_missing_attribute {

void check(const read::SchemaFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "<" + std::string(fact.element.name()) + "> lacks the attribute '" +
                             std::string(fact.node->name()) + "'"});
}

void check_ways(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "<" + fact.name + "> lacks " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-missing-attribute",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "required attribute is missing",
      .why = "MuJoCo rejects the file: the attribute has no default.",
      .what_to_do = "Add the attribute.",
      .checks = {on_schema({read::SchemaFactKind::kMissingAttribute}, check),
                 on_mjcf({read::MjcfFactKind::kAttributeMissing}, check_ways)},
  };
}

}  // namespace rigor::rules::mjcf_missing_attribute
