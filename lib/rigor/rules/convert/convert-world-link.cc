// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_world_link {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, std::string("hangs on the world: in URDF that is a massless link named world")));
}

Rule rule() {
  return {
      .name = "convert-world-link",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "the robot is fixed to a link named world",
      .why =
          "In SDF a joint may have the world as its parent. By habit URDF has a massless link of "
          "that name, which ROS tools know.",
      .what_to_do = "Nothing: the robot is the same.",
      .checks = {on_conversion({convert::NoteKind::kWorldLink}, check)},
  };
}

}  // namespace rigor::rules::convert_world_link
