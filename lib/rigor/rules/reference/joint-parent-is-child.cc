// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_parent_is_child {

/// libsdformat compares what the names lead to in models that are not nested only, and the names in all.
/// urdfdom does not come to a link that is the child of no other joint.
bool refused(const model::FrameProblem& problem, const Context& context) {
  if (context.is_urdf()) {
    const auto& joints = context.root().joints;
    return std::count_if(joints.begin(), joints.end(), [&problem](const model::Joint& joint) {
             return joint.child.value == problem.name;
           }) > 1;
  }
  if (!problem.model || !context.root()[problem.model].parent) return true;
  auto joint = context.document().element_at(problem.where.begin);
  while (joint && joint->name() != "joint") joint = joint->parent();
  const auto parent = joint ? joint->child("parent") : std::nullopt;
  const auto child = joint ? joint->child("child") : std::nullopt;
  return parent && child && read::trimmed(parent->text()) == read::trimmed(child->text());
}

void check(const model::FrameProblem& problem, Context& context) {
  context.report(
      {.where = problem.where,
       .message = "parent and child of the joint are the same link: '" + problem.name + "'",
       .subject = problem.subject,
       .refused = refused(problem, context)});
}

Rule rule() {
  return {
      .name = "joint-parent-is-child",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a joint connects a link with itself",
      .why = "libsdformat rejects the model. Where frames resolve to one link, its check, which "
             "compares names, accepts it, and a physics engine gets a joint between a body and "
             "itself. urdfdom accepts it, and walking the tree then never ends: check_urdf does "
             "not return.",
      .what_to_do = "Name two links. If the two were meant to be one body, remove the joint.",
      .checks = {on_frames({model::FrameProblemKind::kParentIsChild}, check)},
  };
}

}  // namespace rigor::rules::joint_parent_is_child
