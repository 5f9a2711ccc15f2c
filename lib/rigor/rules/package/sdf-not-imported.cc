// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::sdf_not_imported {

void check(const model::Root& root, Context& context) {
  if (root.models.empty()) return;
  context.report({.where = root.site.name,
                  .message = "MuJoCo and Isaac Sim read URDF, MJCF or USD, and no SDF",
                  .help = "rigor sdf2urdf writes a URDF of a model"});
}

Rule rule() {
  return {
      .name = "sdf-not-imported",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kMujoco, Target::kIsaac},
      .summary = "a model in SDF is for a simulator that reads none",
      .why = "MuJoCo takes MJCF and URDF, by the root element. Isaac Sim imports URDF and MJCF "
             "into USD.",
      .what_to_do = "Convert it: `rigor sdf2urdf model.sdf -o robot.urdf`. What URDF cannot say is "
                    "told then.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sdf_not_imported
