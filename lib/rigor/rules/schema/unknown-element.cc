// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>
#include <rigor/rules/schema/misspelt.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::unknown_element {

/// What no version of SDF has and gz-sensors reads all the same: libsdformat copies it.
bool read_by_gazebo(const read::SchemaFact& fact) {
  const std::string_view name = fact.element.name();
  return (name == "gz_frame_id" || name == "ignition_frame_id") && fact.ancestor(1) == "sensor";
}

/// What `missing-element` and `geometry-empty` tell.
bool is_reported_as_missing(const read::SchemaFact& fact, const Context& context) {
  const std::string_view parent = fact.parent->name();
  if (context.is_urdf() && parent == "geometry") return true;
  for (const schema::Node required : fact.parent->required_children()) {
    if (fact.has_sibling(required.name()) || !is_needed(parent, required.name(), context)) continue;
    if (!schema::near(fact.element.name(), {required.name()}).empty()) return true;
  }
  return false;
}

void check(const read::SchemaFact& fact, Context& context) {
  const schema::Version version = fact.parent->version();
  const std::string_view name = fact.element.name();
  if (!context.schema()->parents_of(name, version).empty()) return;  // misplaced-element
  if (dialect_reader(fact, context)) return;                         // consumer-specific-name
  if (read_by_gazebo(fact) || is_reported_as_missing(fact, context)) return;
  auto known = node_names(fact.parent->children());
  for (const auto other : schema::dialect_names(dialect_format(context), fact.parent->name())) {
    if (!other.starts_with('@')) known.push_back(other);
  }
  const auto near = schema::near(name, known);
  std::optional<Fix> fix;
  if (near.size() == 1 && !fact.has_sibling(near.front())) {
    const std::string meant(near.front());
    fix = fix_of("write <" + meant + ">", Applicability::kUnsafe,
                 xml::rename_element(context.document(), fact.element, meant));
  }
  context.report({.where = fact.where,
                  .message = "<" + std::string(name) + "> is not an element of " +
                             format_and_version(context, version) + ": it has no effect",
                  .subject = subject_of(fact.element),
                  .help = near.empty() ? "" : "did you mean <" + std::string(near.front()) + ">?",
                  .fix = std::move(fix)});
}

Rule rule() {
  return {
      .name = "unknown-element",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "unknown element",
      .why = "libsdformat and Gazebo ignore it and everything in it; only newer libsdformat warns. "
             "urdfdom ignores it silently. Most are misspelt. Elements that another known consumer "
             "reads are reported by consumer-specific-name.",
      .what_to_do = "Write the name that was meant. Elements of your own take a prefix, as in "
                    "<mine:note>, and are not reported.",
      .checks = {on_schema({read::SchemaFactKind::kUnknownElement}, check)},
  };
}

}  // namespace rigor::rules::unknown_element
