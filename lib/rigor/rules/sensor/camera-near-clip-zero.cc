// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::camera_near_clip_zero {

void check(const model::Sensor& sensor, Context& context) {
  for (const model::Camera& camera : sensor.cameras) {
    const auto& near = camera.near_clip;
    // In SDF the schema's rules report one below 0; camera-clip-inverted of one that is the far one.
    const bool zero = context.is_sdf() ? near.value == 0 : near.value <= 0;
    if (!near.written || !zero || camera.far_clip.value <= near.value) continue;
    context.report({.where = near.span,
                    .message = fmt::format("the camera sees from {} m on; it has to be more than 0",
                                           near.value),
                    .subject = context.subject(sensor),
                    .fix = Fix{"from 1 cm on", Applicability::kUnsafe, {{near.span, "0.01"}}}});
  }
}

Rule rule() {
  return {
      .name = "camera-near-clip-zero",
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "the near clip distance of a camera is 0",
      .why = "OGRE, which draws for Gazebo, throws \"Near clip distance must be greater than "
             "zero\"; libsdformat takes the file. What a camera sees is divided by its distance.",
      .what_to_do = "Write a small distance, such as 0.01 m; the smaller it is, the coarser are "
                    "the depths far away.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::camera_near_clip_zero
