// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/gazebo_content.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::gazebo_name_misspelt {

using Kind = read::SchemaFactKind;

bool is_about_a_name(const read::SchemaFact& fact) {
  return fact.kind == Kind::kUnknownElement || fact.kind == Kind::kUnknownAttribute ||
         fact.kind == Kind::kWrongCase;
}

/// Whether SDF has an element of that name somewhere: it is misplaced, and not misspelt.
bool is_known_elsewhere(const read::SchemaFact& fact, const Context& context) {
  return fact.kind == Kind::kUnknownElement &&
         !context.sdf_schema().parents_of(fact.element.name(), fact.parent->version()).empty();
}

std::optional<Fix> write_instead(const read::SchemaFact& fact, const std::string& meant,
                                 const Context& context) {
  if (fact.attribute) {
    if (fact.element.attribute(meant)) return std::nullopt;
    return Fix{"write '" + meant + "'", Applicability::kUnsafe, {{fact.where, meant}}};
  }
  if (fact.element.parent()->child(meant)) return std::nullopt;
  return fix_of("write <" + meant + ">", Applicability::kUnsafe,
                xml::rename_element(context.document(), fact.element, meant));
}

void check(const model::GazeboBlock& block, Context& context) {
  check_copied(block, context, [&](const read::SchemaFact& fact) {
    if (!is_about_a_name(fact) || is_known_elsewhere(fact, context)) return;
    const bool attribute = fact.attribute.has_value();
    const std::string name(attribute ? fact.attribute->name() : fact.element.name());
    const auto near = schema::near(
        name, node_names(attribute ? fact.parent->attributes() : fact.parent->children()));
    if (near.empty()) return;  // of a plugin, or of a simulator of its own
    const std::string meant(near.front());
    context.report({.where = fact.where,
                    .message = (attribute ? "the attribute '" + name + "'" : "<" + name + ">") +
                               " of <" + std::string(fact.parent->name()) + "> has no effect",
                    .help = "did you mean " + (attribute ? "'" + meant + "'?" : "<" + meant + ">?"),
                    .fix = near.size() == 1 ? write_instead(fact, meant, context) : std::nullopt});
  });
}

Rule rule() {
  return {
      .name = "gazebo-name-misspelt",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a name inside a sensor of a <gazebo> block is nearly one of SDF",
      .why = "libsdformat copies sensors, and all else that a <gazebo> block has of SDF, into the "
             "link or the joint, and Gazebo passes over the names that it does not know there: the "
             "default counts instead of what is written, and nobody says so. Names that are near "
             "to none of SDF are left alone; a plugin may read them.",
      .what_to_do = "Write the name that was meant; letter case counts.",
      .checks = {on<model::GazeboBlock>(check)},
  };
}

}  // namespace rigor::rules::gazebo_name_misspelt
