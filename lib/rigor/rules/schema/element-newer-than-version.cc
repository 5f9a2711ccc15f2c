// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::element_newer_than_version {

/// Every version of libsdformat reads an <include> by itself, whatever the version of the file.
bool of_include(const read::SchemaFact& fact) {
  return fact.element.name() == "include" || fact.ancestor(1) == "include";
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
                  .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "element-newer-than-version",
      .severity = Severity::kInfo,
      .summary = "an element or attribute is newer than the version of the file",
      .why = "A reader that goes by the version of the file passes over it; libsdformat goes by "
             "the newest version that it knows, so the effect depends on who reads.",
      .what_to_do = "Raise the version of the file, or write what the older version has.",
      .checks = {on_schema({read::SchemaFactKind::kNewerThanVersion}, check)},
  };
}

}  // namespace rigor::rules::element_newer_than_version
