// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::srdf_state_outside_limits {

using robot::SrdfFactKind;

void check(const model::Root&, Context& context) {
  report_srdf(context, {SrdfFactKind::kStateOutside});
}

Rule rule() {
  return {
      .name = "srdf-state-outside-limits",
      .severity = Severity::kError,
      .summary = "a named state is outside a joint's limits",
      .why = "MoveIt refuses a goal outside the bounds of a joint, and a plan from a state that is "
             "outside. Its bounds are the limits, or the soft limits of <safety_controller> where "
             "they are narrower.",
      .what_to_do = "Write a position within the limits, in radians or meters, or correct "
                    "the limits of the joint.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::srdf_state_outside_limits
