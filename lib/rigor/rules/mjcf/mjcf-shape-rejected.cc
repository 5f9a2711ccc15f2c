// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_shape_rejected {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "MuJoCo does not take " + fact.detail,
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-shape-rejected",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "shape that MuJoCo does not have",
      .why = "MuJoCo rejects the file: fromto is for capsules, cylinders, boxes and ellipsoids, "
             "between two ends that are apart, and without a pos beside it; a site is no plane or "
             "height field, a plane does not move, and the shell of a mesh is asked for in its "
             "asset.",
      .what_to_do = "Choose another type, or place the shape by pos.",
      .checks = {on_mjcf({read::MjcfFactKind::kShapeRejected}, check)},
  };
}

}  // namespace rigor::rules::mjcf_shape_rejected
