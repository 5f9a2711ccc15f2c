// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_mesh_empty {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "mesh '" + fact.name + "' has no file and no vertices",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-mesh-empty",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "mesh asset without a file or vertices",
      .why = "MuJoCo rejects the file: a mesh needs a file, vertices or a built-in shape.",
      .what_to_do = "Add file, vertex or builtin.",
      .checks = {on_mjcf({read::MjcfFactKind::kMeshEmpty}, check)},
  };
}

}  // namespace rigor::rules::mjcf_mesh_empty
