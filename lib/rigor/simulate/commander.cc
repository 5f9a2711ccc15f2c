// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/commander.h>

#include <algorithm>
#include <cmath>

#include <rigor/simulate/run.h>

namespace rigor::simulate {
namespace {

/// 1/s: a motor without gains closes its error at this rate, and no more than this share of it in a
/// step, which cannot overshoot.
constexpr double kClosingRate = 50;
constexpr double kClosingShare = 0.2;

/// Share of a step: times are sums of steps, and rounded.
constexpr double kMoment = 1e-6;

double command_value(const Command& command, double from, double time) {
  if (!(command.ramp > 0)) return command.value;
  const double share = std::clamp((time - command.begin) / command.ramp, 0.0, 1.0);
  return from + share * (command.value - from);
}

double command_rate(const Command& command, double from, double time) {
  if (!(command.ramp > 0) || time > command.begin + command.ramp) return 0;
  return (command.value - from) / command.ramp;
}

}  // namespace

Commander::Commander(const Scene& scene, const Scenario& scenario, const SolverSettings& settings)
    : scene_(scene), scenario_(scenario), step_(settings.step) {
  const std::vector<std::uint32_t> first = first_axes(scene);
  for (const Command& command : scenario.commands) {
    if (command.joint >= scene.joints.size() ||
        command.axis >= scene.joints[command.joint].axes.size()) {
      throw EngineError("a command for an axis that is not there");
    }
    const std::size_t index = first[command.joint] + command.axis;
    auto commanded = std::find_if(commanded_.begin(), commanded_.end(),
                                  [index](const Commanded& known) { return known.index == index; });
    if (commanded == commanded_.end()) {
      commanded_.push_back({.joint = command.joint, .axis = command.axis, .index = index});
      commanded = commanded_.end() - 1;
    }
    commanded->commands.push_back(&command);
  }
  for (Commanded& commanded : commanded_) {
    std::stable_sort(commanded.commands.begin(), commanded.commands.end(),
                     [](const Command* a, const Command* b) { return a->begin < b->begin; });
  }
}

void Commander::begin(Commanded& commanded, const Command* next, const AxisState& axis,
                      double time) const {
  const bool goes_on = commanded.now != nullptr && commanded.now->kind == next->kind;
  if (goes_on) {
    commanded.from = command_value(*commanded.now, commanded.from, time);
  } else {
    commanded.from = next->kind == CommandKind::kPosition ? axis.position : 0;
    commanded.integral = 0;
  }
  commanded.now = next;
}

void Commander::apply(Commanded& commanded, Engine& engine) const {
  const double time = engine.state().time;
  const double soon = time + kMoment * step_;
  const Command* next = nullptr;
  for (const Command* command : commanded.commands) {
    if (command->begin <= soon && soon < command->end) next = command;
  }
  if (next == nullptr) {
    if (commanded.now != nullptr) engine.release(commanded.joint, commanded.axis);
    commanded.now = nullptr;
    return;
  }
  const AxisState axis = engine.state().axes[commanded.index];
  if (next != commanded.now) begin(commanded, next, axis, time);
  const double value = command_value(*next, commanded.from, time);
  const double fastest = scene_.joints[commanded.joint].axes[commanded.axis].velocity;
  switch (next->kind) {
    case CommandKind::kEffort:
      engine.set_effort(commanded.joint, commanded.axis,
                        std::clamp(value, -next->effort, next->effort));
      return;
    case CommandKind::kVelocity:
      engine.set_motor(commanded.joint, commanded.axis, std::clamp(value, -fastest, fastest),
                       next->effort);
      return;
    case CommandKind::kPosition: reach_position(commanded, engine, axis, time); return;
  }
}

void Commander::reach_position(Commanded& commanded, Engine& engine, const AxisState& axis,
                               double time) const {
  const Command& command = *commanded.now;
  const SceneAxis& written = scene_.joints[commanded.joint].axes[commanded.axis];
  const double error = command_value(command, commanded.from, time) - axis.position;
  const double rate = command_rate(command, commanded.from, time);
  if (!command.gains) {
    const double closing = std::min(kClosingRate, kClosingShare / step_) * error;
    const double velocity = std::clamp(rate + closing, -written.velocity, written.velocity);
    engine.set_motor(commanded.joint, commanded.axis, velocity, command.effort);
    return;
  }
  const Gains& gains = *command.gains;
  if (command.control == Control::kImplicit) {
    engine.set_servo(commanded.joint, commanded.axis,
                     {gains.p, gains.d, error, rate, command.effort});
    return;
  }
  const double most = std::min(command.effort, written.effort);
  const double integral = commanded.integral + error * step_;
  const double wanted = gains.p * error + gains.i * integral + gains.d * (rate - axis.velocity);
  const double effort = std::clamp(wanted, -most, most);
  // While the effort is cut, summing up would only wind it up.
  if (wanted == effort) commanded.integral = integral;
  engine.set_effort(commanded.joint, commanded.axis, effort);
}

/// The table turns by an angle, so gravity, as the table sees it, by the opposite.
void Commander::tilt(Engine& engine, double time) const {
  const Tilt* last = nullptr;
  for (const Tilt& tilt : scenario_.tilts) {
    if (tilt.begin <= time && (last == nullptr || tilt.begin >= last->begin)) last = &tilt;
  }
  if (last == nullptr) return;
  const double span = last->end - last->begin;
  const double share = span > 0 ? std::min(1.0, (time - last->begin) / span) : 1;
  engine.set_gravity(
      model::rotate(model::from_axis_angle(last->axis, -share * last->angle), scene_.gravity));
}

void Commander::tell(Engine& engine) {
  const double time = engine.state().time;
  for (Commanded& commanded : commanded_) apply(commanded, engine);
  for (const Push& push : scenario_.pushes) {
    const double since = (time - push.at) / step_;
    if (since >= -kMoment && since < 1 - kMoment) engine.push(push.body, push.impulse_W, push.p_BP);
  }
  tilt(engine, time);
}

}  // namespace rigor::simulate
