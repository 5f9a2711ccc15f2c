// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/resolve.h>
#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::moving_link_massless {

/// Per link, whether it has mass, or anything that is fixed to it has.
std::vector<bool> with_mass(const model::Root& root, const Context& context) {
  std::vector<std::vector<model::Id<model::Link>>> fixed_to(root.links.size());
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const auto& ends = context.frames().ends({i});
    if (root.joints[i].type != model::JointType::kFixed || !ends.parent || !ends.child) continue;
    fixed_to[ends.child.value].push_back(ends.parent);
  }
  std::vector<bool> heavy(root.links.size(), false);
  std::vector<model::Id<model::Link>> open;
  const auto add = [&heavy, &open](model::Id<model::Link> link) {
    if (heavy[link.value]) return;
    heavy[link.value] = true;
    open.push_back(link);
  };
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    if (mass::resolve(root, {i}).mass != 0) add({i});
  }
  while (!open.empty()) {
    const model::Id<model::Link> link = open.back();
    open.pop_back();
    for (const auto parent : fixed_to[link.value]) add(parent);
  }
  return heavy;
}

/// An <inertial> without its numbers is another rule's affair, as is one of moments and no mass. With
/// neither, it says what no <inertial> says.
bool is_reported_elsewhere(const model::Link& link) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.written) return false;
  if (!inertial.mass.written || !inertial.tensor_written) return true;
  return !(mass::tensor(inertial) == mass::Inertia{});
}

/// All of its links are one fault, and a robot without joints is a piece of scenery.
void report_robot(const model::Root& root, Context& context) {
  const bool any_written = std::any_of(
      root.links.begin(), root.links.end(),
      [](const model::Link& link) { return link.inertial.written && is_reported_elsewhere(link); });
  const auto moves = [](const model::Joint& joint) {
    return joint.type != model::JointType::kFixed && joint.type != model::JointType::kUnknown;
  };
  const bool any_moves = std::any_of(root.joints.begin(), root.joints.end(), moves);
  if (any_written || !any_moves || root.models.empty()) return;
  const model::Model& robot = root.models.front();
  context.report(
      {.where = robot.site.name,
       .message = fmt::format("no link of the robot{} has a mass: simulators load "
                              "nothing of it",
                              robot.name.value.empty() ? "" : " '" + robot.name.value + "'"),
       .subject = context.subject(robot),
       .help = "add an <inertial> to each link that moves: `rigor inertia MODEL "
               "--density KG_PER_M3 --write` computes them",
       .cause = "no link has a mass"});
}

void check(const model::Root& root, Context& context) {
  const std::vector<bool> heavy = with_mass(root, context);
  if (std::find(heavy.begin(), heavy.end(), true) == heavy.end()) {
    report_robot(root, context);
    return;
  }
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    const model::Id<model::Link> child = context.frames().ends({i}).child;
    if (joint.type == model::JointType::kFixed || joint.type == model::JointType::kUnknown) {
      continue;
    }
    if (!child || heavy[child.value] || is_reported_elsewhere(root[child])) continue;
    const model::Link& link = root[child];
    context.report({.where = link.site.name,
                    .message = fmt::format("the joint '{}' moves the link '{}', which has no mass, "
                                           "and nor has anything that is fixed to it",
                                           joint.name.value, link.name.value),
                    .subject = context.subject(link),
                    .related = {{joint.site.name, "moved by this joint"}},
                    .fix = fix_from_shapes(link, context),
                    .cause = "massless links of " + root[link.model].name.value});
  }
}

Rule rule() {
  return {
      .name = "moving-link-massless",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint of a URDF moves a link without mass",
      .why = "Gazebo drops a link without mass that a joint moves, its joint and their subtree; "
             "MuJoCo rejects the robot. A link without <inertial> has no mass in URDF: fixed to "
             "others it is a normal frame. A robot without any mass is reported once.",
      .what_to_do = "Give the link a mass and a tensor, however small, or fix the joint.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::moving_link_massless
