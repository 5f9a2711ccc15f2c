// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/sdformat_robot.h>

namespace rigor::rules::no_link_left_in_sdf {

/// A static model may be without links.
bool made_static(const Context& context) {
  const auto& blocks = context.root().gazebo_blocks;
  return std::any_of(blocks.begin(), blocks.end(), [&](const model::GazeboBlock& block) {
    const auto* flag = find(block.content, "static");
    return flag != nullptr && block.reference.value.empty() && is_true(*flag);
  });
}

void check(const model::Model& robot, Context& context) {
  const SdformatRobot& left = context.sdformat_robot();
  if (!left.known || left.links > 0 || made_static(context)) return;
  std::string root;
  for (std::size_t i = 0; i < left.parts.size(); ++i) {
    const model::Link& link = context.root()[robot.links[i]];
    if (!left.parts[i].joint && link.name.value != "world") root = link.name.value;
  }
  context.report({.where = robot.site.name,
                  .message = "libsdformat leaves no link of this robot" +
                             (root.empty() ? std::string()
                                           : ": its root '" + root +
                                                 "' has no mass, and all other "
                                                 "links hang on it"),
                  .subject = context.subject(robot)});
}

Rule rule() {
  return {
      .name = "no-link-left-in-sdf",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .targets = {Target::kGazeboClassic, Target::kGzSim},
      .summary = "nothing is left of a URDF robot when Gazebo reads it",
      .why =
          "Gazebo reads URDF through libsdformat, which leaves out links without mass and whatever "
          "hangs on them. Only a link at a fixed joint gives its mass to its parent. When the root "
          "is left out, so is the robot, and version 12 refuses a model without links (error 16).",
      .what_to_do =
          "Give the root an <inertial>, or attach a link that has one to it by a fixed joint.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::no_link_left_in_sdf
