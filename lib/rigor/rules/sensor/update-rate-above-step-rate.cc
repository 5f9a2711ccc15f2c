// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::update_rate_above_step_rate {

// A rate is written rounded: 60 for a step of 0.0167 s.
constexpr double kRounding = 1.02;

void check(const model::Root& root, Context& context) {
  // Of several profiles the one that is used is chosen elsewhere.
  if (root.worlds.size() != 1 || root.physics.size() != 1) return;
  const auto& step = root.physics.front().max_step_size;
  if (!step.written || !(step.value > 0)) return;
  const double most = 1 / step.value;
  for (const model::Sensor& sensor : root.sensors) {
    const auto& rate = sensor.update_rate;
    if (!root.own(sensor.site) || !rate.written || !(rate.value > most * kRounding)) continue;
    context.report(
        {.where = rate.span,
         .message = fmt::format(
             "the sensor is to measure {} times in a second, and the world makes {:.4g} steps",
             rate.value, most),
         .subject = context.subject(sensor),
         .related = {{step.span, "the step, in seconds"}}});
  }
}

Rule rule() {
  return {
      .name = "update-rate-above-step-rate",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a sensor is to measure more often than its world makes steps",
      .why = "The sensor measures once per step, less often than requested, without a warning. A "
             "simulated sensor measures at the end of a step.",
      .what_to_do = "Lower the update_rate, or make the max_step_size of <physics> smaller.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::update_rate_above_step_rate
