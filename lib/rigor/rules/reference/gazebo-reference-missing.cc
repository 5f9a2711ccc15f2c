// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>
#include <vector>

#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::gazebo_reference_missing {

void check(const model::Root& root, Context& context) {
  const auto links = name_set(root.links);
  const auto joints = name_set(root.joints);
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    const std::string& name = block.reference.value;
    if (name.empty() || links.count(name) != 0 || joints.count(name) != 0) continue;
    const auto all = [&root] {
      std::vector<std::string> names = names_of(root.links);
      for (std::string& joint : names_of(root.joints)) names.push_back(std::move(joint));
      return names;
    };
    context.report(with_nearest(
        {.where = block.reference.span,
         .message = "refers to '" + name + "', which is no link and no joint of this robot",
         .why =
             block.empty ? "Gazebo drops the block silently; it is empty, so nothing is lost." : "",
         .severity = block.empty ? std::optional(Severity::kInfo) : std::nullopt},
        name, all, context));
  }
}

Rule rule() {
  return {
      .name = "gazebo-reference-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a <gazebo> block is for a link or joint that does not exist",
      .why = "Gazebo drops the block silently: its material, friction, sensors and plugins are not "
             "there.",
      .what_to_do = "Name a link or a joint of the robot, or remove the block.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::gazebo_reference_missing
