// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>
#include <string_view>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_rejected_by_ros2_control {

std::set<std::string_view> joints_of(const model::Parameter& block) {
  std::set<std::string_view> names;
  for (const model::Parameter& child : block.children) {
    const auto* name = attribute(child, "name");
    if (child.name == "joint" && name != nullptr) names.insert(name->value);
  }
  return names;
}

void check_joint(const model::Parameter& element, const model::Joint& joint,
                 const std::set<std::string_view>& listed, Context& context) {
  const auto* said = attribute(element, "mimic");
  const std::string_view says = said != nullptr ? std::string_view(said->value) : "";
  const model::Mimic* mimic =
      joint.axes.empty() || !joint.axes.front().mimic ? nullptr : &*joint.axes.front().mimic;
  const std::string name = "the joint '" + joint.name.value + "'";
  if (mimic == nullptr) {
    if (says != "true" && says != "True" && says != "1") return;
    context.report({.where = said->span, .message = name + " mimics no other"});
    return;
  }
  if (says == "false" || says == "False" || says == "0") return;
  const std::string& leader = mimic->joint.value;
  const Span where = attribute(element, "name")->span;
  if (find(element.children, "command_interface") != nullptr) {
    context.report(
        {.where = where,
         .message = name + " mimics '" + leader + "', and so it may have no command interface",
         .related = {{mimic->site.name, "the mimic"}}});
  } else if (listed.count(leader) == 0) {
    context.report({.where = where,
                    .message = name + " mimics '" + leader + "', which is not in this block",
                    .related = {{mimic->site.name, "the mimic"}}});
  }
}

void check(const model::Root& root, Context& context) {
  if (root.models.empty()) return;
  for (const model::Parameter& block : root.ros2_controls) {
    if (!root.own(block.site)) continue;
    const std::set<std::string_view> listed = joints_of(block);
    for (const model::Parameter& child : block.children) {
      const auto* name = attribute(child, "name");
      if (child.name != "joint" || name == nullptr) continue;
      const auto id = joint_named(context.frames(), {0}, name->value);
      if (id) check_joint(child, root[id], listed, context);
    }
  }
}

Rule rule() {
  return {
      .name = "mimic-rejected-by-ros2-control",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .summary = "ros2_control rejects the interfaces of a mimic joint",
      .why = "ros2_control of Jazzy and later reads mimics from the robot itself, and its "
             "controller manager ends with an exception. A mimic joint must not have a command "
             "interface, its leader has to be in the same block, and mimic=\"true\" needs a "
             "<mimic>.",
      .what_to_do = "Remove the command interface, list the leader in the block, or set "
                    "mimic=\"false\" on the joint in the block.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mimic_rejected_by_ros2_control
