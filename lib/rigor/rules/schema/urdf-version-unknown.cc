// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::urdf_version_unknown {

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is no version of URDF",
                  .fix = Fix{"write 1.0", Applicability::kUnsafe, {{fact.where, "1.0"}}}});
}

Rule rule() {
  return {
      .name = "urdf-version-unknown",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "no such version of URDF exists",
      .why = "urdfdom refuses the robot: it knows 1.0 and, in its newest release, 1.2.",
      .what_to_do = "Write version=\"1.0\", or leave the attribute out.",
      .checks = {on_read({read::FactKind::kVersionUnknown}, check)},
  };
}

}  // namespace rigor::rules::urdf_version_unknown
