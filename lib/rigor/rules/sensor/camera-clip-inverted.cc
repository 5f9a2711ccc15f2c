// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/plugin/gazebo_block.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::camera_clip_inverted {

// What the schema of SDF allows. Its rules report less in SDF, and no rule of the schema checks a URDF's <gazebo>.
constexpr double kMinFarInSdf = 0.1;
constexpr double kMinNearInSdf = 0;

void check(const model::Sensor& sensor, Context& context) {
  for (const model::Camera& camera : sensor.cameras) {
    if (camera.near_clip.value < camera.far_clip.value) continue;
    const auto& at = camera.near_clip.written ? camera.near_clip : camera.far_clip;
    if (!at.written) continue;
    std::optional<Fix> fix;
    if (camera.near_clip.written && camera.far_clip.written &&
        camera.far_clip.value < camera.near_clip.value) {
      fix = swap("swap near and far", camera.near_clip.span, camera.far_clip.span, context);
    }
    context.report({.where = at.span,
                    .message = fmt::format("the camera sees from {} m to {} m: the range is empty",
                                           camera.near_clip.value, camera.far_clip.value),
                    .subject = context.subject(sensor),
                    .fix = std::move(fix),
                    .refused = context.is_urdf() && is_in_part(sensor) &&
                               (camera.near_clip.value < kMinNearInSdf ||
                                camera.far_clip.value < kMinFarInSdf)});
  }
}

Rule rule() {
  return {
      .name = "camera-clip-inverted",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "the near clip distance of a camera is not before the far one",
      .why = "The renderer shows an empty image or stops. The checker (ign sdf -k, gz sdf -k) does "
             "not compare the two.",
      .what_to_do = "Write a near distance below the far one, in meters.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::camera_clip_inverted
