// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_mesh_scale_zero {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the scale of mesh '" + fact.name + "' has a zero",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-mesh-scale-zero",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "mesh scale of zero",
      .why = "MuJoCo rejects the file: a mesh that is scaled to a plane, a line or a point has no "
             "volume.",
      .what_to_do = "Write three numbers that are not zero; 0.001 for a mesh in millimeters.",
      .checks = {on_mjcf({read::MjcfFactKind::kMeshScaleZero}, check)},
  };
}

}  // namespace rigor::rules::mjcf_mesh_scale_zero
