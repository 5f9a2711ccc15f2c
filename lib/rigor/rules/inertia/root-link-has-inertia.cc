// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules::root_link_has_inertia {

void check(const model::Model& robot, Context& context) {
  if (robot.joints.empty()) return;
  const model::Root& root = context.root();
  std::vector<bool> is_child(root.links.size(), false);
  for (const auto id : robot.joints) {
    const auto& ends = context.frames().ends(id);
    if (!ends.parent || !ends.child) return;  // what hangs on what is not known
    is_child[ends.child.value] = true;
  }
  const model::Link* base = nullptr;
  for (const auto id : robot.links) {
    if (is_child[id.value]) continue;
    if (base != nullptr) return;  // several-roots tells it
    base = &root[id];
  }
  if (base == nullptr || !base->inertial.written) return;
  context.report({.where = base->inertial.site.name,
                  .message = "KDL gives the root link no inertia: this <inertial> is passed over",
                  .subject = context.subject(*base)});
}

Rule rule() {
  return {
      .name = "root-link-has-inertia",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .targets = {Target::kRos},
      .summary = "the root link of a robot has an inertia, which KDL cannot hold",
      .why = "robot_state_publisher, MoveIt's solvers and others make a KDL tree of the robot, "
             "whose root is a frame without mass. kdl_parser warns that it does not support a root "
             "link with an inertia, and leaves it out of the dynamics.",
      .what_to_do = "Put an empty link before it: <link name=\"base_footprint\"/> and a fixed "
                    "joint from that to this link. Simulators merge the two.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::root_link_has_inertia
