// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::element_newer_than_version {

/// Every version of libsdformat reads an <include> by itself, whatever the version of the file; of its pose
/// the numbers only.
bool of_include(const read::SchemaFact& fact) {
  if (fact.attribute && fact.element.name() == "pose") return false;
  return fact.element.name() == "include" || fact.ancestor(1) == "include";
}

bool is_unit(const read::SchemaFact& fact) {
  return fact.attribute && fact.attribute->name() == "degrees";
}

void check(const read::SchemaFact& fact, Context& context) {
  if (context.is_sdf() && of_include(fact)) return;
  if (context.is_urdf() && fact.element.name() == "capsule") return;  // shape-newer-than-urdf
  const std::string format = context.is_urdf() ? "URDF " : "SDF ";
  const std::string since = schema::to_string(fact.node->since());
  context.report({.where = fact.where,
                  .message = "'" + std::string(context.bytes(fact.where)) + "' came with " +
                             format + since + ": this file is " + format +
                             schema::to_string(fact.parent->version()),
                  .subject = subject_of(fact.element),
                  .why = is_unit(fact) ? "libsdformat 12 and later read the angles in degrees in a "
                                         "file of any version, older ones and Gazebo classic in "
                                         "radians."
                                       : ""});
}

Rule rule() {
  return {
      .name = "element-newer-than-version",
      .severity = Severity::kInfo,
      .summary = "an element or attribute is newer than the version of the file",
      .why = "A reader that uses the version of the file ignores it; libsdformat uses the newest "
             "version that it knows, so the effect depends on the reader.",
      .what_to_do = "Raise the version of the file, or write what the older version has.",
      .checks = {on_schema({read::SchemaFactKind::kNewerThanVersion}, check)},
  };
}

}  // namespace rigor::rules::element_newer_than_version
