// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_control_range {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "<" + fact.name + "> needs a ctrlrange from 0 or more to a larger number"});
}

Rule rule() {
  return {
      .name = "mjcf-control-range",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "adhesion or damper without a control range",
      .why = "MuJoCo rejects the file: adhesion and dampers take no control below 0, and have to "
             "have a "
             "range of controls.",
      .what_to_do = "Write ctrlrange=\"0 1\", with the largest control that is meant.",
      .checks = {on_mjcf({read::MjcfFactKind::kControlRange}, check)},
  };
}

}  // namespace rigor::rules::mjcf_control_range
