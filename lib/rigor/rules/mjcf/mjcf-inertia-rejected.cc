// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_inertia_rejected {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.name + ": " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-inertia-rejected",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "inertia that MuJoCo rejects",
      .why = "MuJoCo rejects the file: a mass is not negative, a full tensor is positive definite, "
             "and of its moments two are together no less than the third, unless <compiler "
             "balanceinertia> is true. No rigid body has other values.",
      .what_to_do = "Compute the inertia of the body, as rigor inertia does.",
      .checks = {on_mjcf({read::MjcfFactKind::kInertiaRejected}, check)},
  };
}

}  // namespace rigor::rules::mjcf_inertia_rejected
