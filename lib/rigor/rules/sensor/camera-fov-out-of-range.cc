// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <numbers>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::camera_fov_out_of_range {

// Of a flat picture the edges go to infinity at half a turn; 3.14 is meant to be that, too.
constexpr double kWidest = 3.135;
// What the schema of SDF allows: beyond that its rules speak.
constexpr double kMaxInSdf = 6.283186;
constexpr double kMinInSdf = 0.001;
constexpr double kMaxDegrees = 180;

void check(const model::Sensor& sensor, Context& context) {
  if (sensor.type.value.starts_with("wide")) return;  // a fish eye sees more
  for (const model::Camera& camera : sensor.cameras) {
    const auto& fov = camera.horizontal_fov;
    if (!fov.written || (fov.value > 0 && fov.value < kWidest)) continue;
    if (context.is_sdf() && (fov.value < kMinInSdf || fov.value > kMaxInSdf)) continue;
    Finding finding{
        .where = fov.span,
        .message = fmt::format("the camera sees {} rad across, more than a flat image can show",
                               fov.value),
        .subject = context.subject(sensor),
        .refused = context.is_urdf() && is_in_part(sensor) &&
                   !(fov.value >= kMinInSdf && fov.value <= kMaxInSdf)};
    if (!(fov.value > 0)) {
      finding.message = fmt::format("the field of view is {} rad", fov.value);
    } else if (fov.value > kMaxInSdf && fov.value < kMaxDegrees) {
      const std::string radians = fmt::format("{:.6g}", fov.value * std::numbers::pi / 180);
      finding.help = "as degrees it would be " + radians + " rad";
      finding.fix = Fix{"write " + radians, Applicability::kUnsafe, {{fov.span, radians}}};
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "camera-fov-out-of-range",
      .severity = Severity::kWarning,
      .refused = {.urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "the field of view of a camera is not between 0 and half a turn",
      .why = "The image of a simulated camera is stretched to a line, or empty. A flat image shows "
             "less than half a turn: its width is twice the tangent of half the angle, which has "
             "no bound at 3.14 rad, and is negative beyond. Only wide-angle cameras see more. In "
             "SDF value-out-of-range reports angles outside the format's bounds; this rule checks "
             "the <gazebo> blocks of a URDF, too.",
      .what_to_do = "Write the angle in radians: 1.047 is 60 degrees. For more than about 2 take a "
                    "sensor of type wideanglecamera.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::camera_fov_out_of_range
