// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/sensor/picture.h>

namespace rigor::rules::camera_image_huge {

// Graphics cards of today draw pictures of at most so many pixels a side.
constexpr double kMaxPixels = 16384;

void check(const model::Sensor& sensor, Context& context) {
  report_pictures(
      sensor, [](double pixels) { return pixels > kMaxPixels; }, context);
}

Rule rule() {
  return {
      .name = "camera-image-huge",
      .severity = Severity::kWarning,
      .summary = "a camera takes images larger than graphics cards can draw",
      .why = "Graphics cards draw images of up to 16384 pixels a side. The renderer fails to make "
             "a larger one; and an image of that size, without depth, is 800 MB that go over the "
             "network each time.",
      .what_to_do = "Write the width and height in pixels, as the camera that is meant has them: "
                    "640 and 480, or 1920 and 1080.",
      .checks = {on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::camera_image_huge
