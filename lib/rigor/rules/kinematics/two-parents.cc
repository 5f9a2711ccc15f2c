// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>

#include <rigor/rules/kinematics/tree.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::two_parents {

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  const Tree tree = tree_of(root, context.frames(), robot);
  for (std::size_t i = 0; i < tree.parents.size(); ++i) {
    if (tree.on_loop[i]) continue;  // kinematic-loop tells it
    const auto& joints = tree.parents[i];
    for (std::size_t k = 1; k < joints.size(); ++k) {
      const model::Joint& first = root[joints.front()];
      const model::Joint& joint = root[joints[k]];
      context.report({.where = joint.child.span,
                      .message = "the link '" + joint.child.value +
                                 "' is already the child of the joint '" + first.name.value + "'",
                      .subject = context.subject(joint),
                      .related = {{first.child.span, "first made a child here"}}});
    }
  }
}

Rule rule() {
  return {
      .name = "two-parents",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .summary = "a link of a URDF has two parents",
      .why = "A URDF is a tree: urdfdom keeps the parent that comes last and shows the link under "
             "both, MuJoCo and Drake refuse the robot.",
      .what_to_do = "Take one of the joints out. URDF cannot close a chain; SDF can.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::two_parents
