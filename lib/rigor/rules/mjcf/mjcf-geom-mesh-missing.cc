// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_geom_mesh_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "geom of type " + fact.name + " names no " +
                             (fact.name == "hfield" ? "height field" : "mesh"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-geom-mesh-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "geom without the mesh or height field of its type",
      .why = "MuJoCo rejects the file: a geom of type mesh or sdf takes its shape from a mesh "
             "asset, one of type hfield from a height field.",
      .what_to_do = "Add mesh or hfield, or choose another type.",
      .checks = {on_mjcf({read::MjcfFactKind::kMeshMissingName}, check)},
  };
}

}  // namespace rigor::rules::mjcf_geom_mesh_missing
