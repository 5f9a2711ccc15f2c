// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::update_rate_negative {

void check(const model::Sensor& sensor, Context& context) {
  const auto& rate = sensor.update_rate;
  if (!rate.written || !(rate.value < 0)) return;
  context.report(
      {.where = rate.span,
       .message = fmt::format("the update rate is {} Hz; 0 is as often as possible", rate.value),
       .subject = context.subject(sensor),
       .fix = Fix{"as often as possible", Applicability::kUnsafe, {{rate.span, "0"}}}});
}

Rule rule() {
  return {
      .name = "update-rate-negative",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the update rate of a sensor is negative",
      .why = "ign sdf -k calls it valid; simulators differ: some never measure, some measure at "
             "every step.",
      .what_to_do = "Write the measurements in one second, or 0 for every step.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::update_rate_negative
