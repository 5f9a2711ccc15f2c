// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::mjcf_unknown_attribute {

void check(const read::SchemaFact& fact, Context& context) {
  if (!fact.attribute) return;  // of an element: mjcf-unknown-element
  const std::string_view name = fact.attribute->name();
  const std::string_view tag = fact.element.name();
  const bool is_ignored = tag == "frame" || tag == "replicate" || fact.is_inside("frame") ||
                          fact.is_inside("replicate");
  const auto near = schema::near(name, node_names(fact.parent->attributes()));
  context.report({.where = fact.where,
                  .message = "'" + std::string(name) + "' is not an attribute of <" +
                             std::string(fact.element.name()) + ">",
                  .help = near.empty() ? "" : "did you mean '" + std::string(near.front()) + "'?",
                  .severity = is_ignored ? std::optional(Severity::kWarning) : std::nullopt});
}

Rule rule() {
  return {
      .name = "mjcf-unknown-attribute",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "unknown attribute",
      .why = "MuJoCo rejects the file: it reads no attribute that its schema does not have, those "
             "of newer and of very old versions included. In a frame or replicate it ignores them.",
      .what_to_do = "Write the attribute that is meant, or remove it.",
      .checks = {on_schema(
          {read::SchemaFactKind::kUnknownAttribute, read::SchemaFactKind::kElementAsAttribute,
           read::SchemaFactKind::kWrongCase, read::SchemaFactKind::kNewerThanVersion,
           read::SchemaFactKind::kRemovedInVersion},
          check)},
  };
}

}  // namespace rigor::rules::mjcf_unknown_attribute
