// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_axis_zero {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("the axis has no length"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-axis-zero",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "joint axis of no length",
      .why = "MuJoCo rejects the file: a hinge or slide needs an axis.",
      .what_to_do = "Write a vector, as in axis=\"0 0 1\".",
      .checks = {on_mjcf({read::MjcfFactKind::kAxisZero}, check)},
  };
}

}  // namespace rigor::rules::mjcf_axis_zero
