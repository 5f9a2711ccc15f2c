// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_color_range {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "rgba " + fact.detail + " has a component over 1",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-color-range",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "color with components over 1",
      .why = "MuJoCo takes colors from 0 to 1: all components over 1 look the same, so "
             "that a color from 0 to 255 is white or one of few.",
      .what_to_do = "Divide the numbers by 255.",
      .checks = {on_mjcf({read::MjcfFactKind::kColor}, check)},
  };
}

}  // namespace rigor::rules::mjcf_color_range
