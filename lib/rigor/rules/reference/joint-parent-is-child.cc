// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::joint_parent_is_child {
namespace {

void check(const model::FrameProblem& problem, Context& context) {
  context.report(
      {.where = problem.where,
       .message = "parent and child of the joint are the same link: '" + problem.name + "'",
       .subject = problem.subject});
}

}  // namespace

Rule rule() {
  return {
      .name = "joint-parent-is-child",
      .category = Category::kReference,
      .severity = Severity::kError,
      .summary = "a joint connects a link with itself",
      .why =
          "libsdformat refuses the model. Where frames lead to one link in the end its check, "
          "which compares names, lets it pass, and a physics engine gets a joint between a body "
          "and itself. urdfdom takes it and whoever then walks the tree never comes to an end: "
          "check_urdf "
          "does not return.",
      .what_to_do = "Name two links. If the two were meant to be one body, take the joint out.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <joint name="elbow" type="fixed">
      <parent>base</parent>
      <child>«base»</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="base"/>
    <link name="tip"/>
    <joint name="elbow" type="fixed">
      <parent>base</parent>
      <child>tip</child>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on_frames({model::FrameProblemKind::kParentIsChild}, check)},
  };
}

}  // namespace rigor::rules::joint_parent_is_child
