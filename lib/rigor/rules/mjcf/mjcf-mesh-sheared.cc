// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_mesh_sheared {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "mesh '" + fact.name +
                             "' is rotated by refquat before its uneven scale, which shears it",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-mesh-sheared",
      .severity = Severity::kInfo,
      .formats = Formats::kMjcf,
      .summary = "mesh that is sheared",
      .why = "MuJoCo rotates the vertices by refquat before it scales them. With a scale "
             "of unequal factors that is no rotation of a scaled mesh, and rigor reads "
             "the mesh without the shear: its shape, mass and bounds differ.",
      .what_to_do = "Scale the mesh evenly, or write the rotated mesh into its file.",
      .checks = {on_mjcf({read::MjcfFactKind::kMeshSheared}, check)},
  };
}

}  // namespace rigor::rules::mjcf_mesh_sheared
