// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::mjcf_unknown_element {

void check(const read::SchemaFact& fact, Context& context) {
  if (fact.attribute) return;  // mjcf-unknown-attribute
  const std::string_view name = fact.element.name();
  const std::string around(fact.ancestor(1));
  const auto near = schema::near(name, node_names(fact.parent->children()));
  context.report({.where = fact.where,
                  .message = "<" + std::string(name) + "> is not an element of <" + around + ">",
                  .help = near.empty() ? "" : "did you mean <" + std::string(near.front()) + ">?"});
}

Rule rule() {
  return {
      .name = "mjcf-unknown-element",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "unknown element",
      .why = "MuJoCo rejects the file: it reads no element that its schema does not have in this "
             "place.",
      .what_to_do = "Write the element that is meant, move it to where it belongs, or remove it.",
      .checks = {on_schema(
          {read::SchemaFactKind::kUnknownElement, read::SchemaFactKind::kAttributeAsElement,
           read::SchemaFactKind::kWrongCase, read::SchemaFactKind::kNewerThanVersion,
           read::SchemaFactKind::kRemovedInVersion},
          check)},
  };
}

}  // namespace rigor::rules::mjcf_unknown_element
