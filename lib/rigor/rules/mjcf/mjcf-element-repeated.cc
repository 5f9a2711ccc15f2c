// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::mjcf_element_repeated {

void check(const read::SchemaFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "a second <" + std::string(fact.element.name()) + "> in <" +
                             std::string(fact.ancestor(1)) + ">",
                  .related = {{fact.related, "the first"}}});
}

Rule rule() {
  return {
      .name = "mjcf-element-repeated",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "element is repeated",
      .why = "MuJoCo rejects the file: there is one of these elements at most.",
      .what_to_do = "Keep one of them.",
      .checks = {on_schema({read::SchemaFactKind::kRepeatedElement}, check)},
  };
}

}  // namespace rigor::rules::mjcf_element_repeated
