// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sensor_misplaced {

using model::Vector3;

// Times as far from the robot as that is long: no mast is.
constexpr double kTimesAway = 10;

std::optional<mesh::Bounds> bounds_of_model(model::Id<model::Model> top,
                                            const robot::Assembled& robot) {
  robot::Links links;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].top == top) links.push_back(i);
  }
  return robot.bounds_W(links);
}

double distance_to(const mesh::Bounds& box, const Vector3& p) {
  const auto beyond = [](double low, double high, double at) {
    return std::max({0.0, low - at, at - high});
  };
  return model::length({beyond(box.min.x, box.max.x, p.x), beyond(box.min.y, box.max.y, p.y),
                        beyond(box.min.z, box.max.z, p.z)});
}

void check(const model::Sensor& sensor, Context& context) {
  const model::Root& root = context.root();
  if (!sensor.pose.pose.written || !sensor.link) return;
  const auto X_WS = context.frames().pose(
      model::Id<model::Sensor>{static_cast<std::uint32_t>(&sensor - root.sensors.data())});
  if (!X_WS) return;
  const auto box =
      bounds_of_model(context.assembled().links[sensor.link.value].top, context.assembled());
  if (!box) return;
  const double size = mesh::diagonal(*box);
  const double away = distance_to(*box, X_WS->translation);
  if (!(away > kTimesAway * size)) return;
  for (const Undone& change : undone_slips(sensor.pose.pose.value.translation)) {
    const Vector3 then = X_WS->translation + shift_of(sensor.pose.pose.value, *X_WS, change.value);
    constexpr double kNear = 0.1;  // of the size
    if (distance_to(*box, then) > kNear * size) continue;
    context.report(
        {.where = place_of(sensor.pose, context),
         .message = fmt::format(
             "the sensor is {:.3g} m away from the robot, which is {:.3g} m long", away, size),
         .subject = context.subject(sensor),
         .help = fmt::format("with {} it is on it: {}", written_as(change.value), change.slip),
         .fix = translation_fix(sensor.pose, change.value, context)});
    return;
  }
}

Rule rule() {
  return {
      .name = "sensor-misplaced",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a sensor is far from the robot that carries it",
      .why = "A camera or lidar measures from a place where the robot is not; an IMU at the end "
             "of a long lever feels accelerations that nothing has. The pose is written in "
             "millimeters or centimeters, or its decimal point slipped: with that undone the "
             "sensor is on the robot.",
      .what_to_do = "Write the pose in meters, in the frame of the link.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::sensor_misplaced
