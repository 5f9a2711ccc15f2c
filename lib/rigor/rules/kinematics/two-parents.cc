// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>
#include <utility>

#include <rigor/rules/kinematics/tree.h>
#include <rigor/rules/rule.h>
#include <rigor/xml/edit.h>

namespace rigor::rules::two_parents {

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  const Tree tree = tree_of(root, context.frames(), robot);
  for (std::size_t i = 0; i < tree.parents.size(); ++i) {
    if (tree.on_loop[i]) continue;  // kinematic-loop tells it
    const auto& joints = tree.parents[i];
    for (std::size_t k = 1; k < joints.size(); ++k) {
      const model::Joint* first = &root[joints.front()];
      const model::Joint* joint = &root[joints[k]];
      const char* other = "first made a child here";
      const model::Link* meant = misnamed_child(*joint, tree, robot, root);
      if (meant == nullptr && (meant = misnamed_child(*first, tree, robot, root)) != nullptr) {
        std::swap(first, joint);
        other = "a child here, too";
      }
      Finding finding{.where = joint->child.span,
                      .message = "the link '" + joint->child.value +
                                 "' is already the child of the joint '" + first->name.value + "'",
                      .subject = context.subject(*joint),
                      .related = {{first->child.span, other}}};
      if (meant != nullptr) {
        finding.help = "'" + meant->name.value + "' is the child of none: is it meant?";
        if (context.bytes(joint->child.span) == joint->child.value) {
          finding.fix = Fix{"name '" + meant->name.value + "'",
                            Applicability::kUnsafe,
                            {{joint->child.span, xml::escaped(meant->name.value)}}};
        }
      }
      context.report(std::move(finding));
    }
  }
}

Rule rule() {
  return {
      .name = "two-parents",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a link of a URDF has two parents",
      .why = "A URDF is a tree: urdfdom keeps the parent that comes last and shows the link under "
             "both, MuJoCo and Drake reject the robot.",
      .what_to_do = "Take one of the joints out. URDF cannot close a chain; SDF can.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::two_parents
