// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::update_rate_above_step_rate {

// A rate is written rounded: 60 for a step of 0.0167 s.
constexpr double kRounding = 1.02;

// Hz. Worlds make 1000 steps unless they say otherwise.
constexpr double kEver = 2000;

void check_alone(const model::Root& root, Context& context) {
  for (const model::Sensor& sensor : root.sensors) {
    const auto& rate = sensor.update_rate;
    if (!root.own(sensor.site) || !rate.written || !(rate.value > kEver)) continue;
    context.report(
        {.where = rate.span,
         .message = fmt::format("the sensor is to measure {} times in a second, and worlds make "
                                "1000 steps in one",
                                rate.value),
         .subject = context.subject(sensor)});
  }
}

void check(const model::Root& root, Context& context) {
  // Of several profiles the one that is used is chosen elsewhere.
  const bool one = root.worlds.size() == 1 && root.physics.size() == 1;
  if (!one || !root.physics.front().max_step_size.written ||
      !(root.physics.front().max_step_size.value > 0)) {
    return check_alone(root, context);
  }
  const auto& step = root.physics.front().max_step_size;
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
      .summary = "a sensor is to measure more often than its world makes steps",
      .why = "The sensor measures once per step, less often than requested, without a warning. A "
             "simulated sensor measures at the end of a step.",
      .what_to_do = "Lower the update_rate, or make the max_step_size of <physics> smaller.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::update_rate_above_step_rate
