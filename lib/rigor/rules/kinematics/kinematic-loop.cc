// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <rigor/rules/kinematics/tree.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::kinematic_loop {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

/// Whether the loop hangs on nothing beside a tree: urdfdom reads the tree and never comes to it.
bool beside_tree(const Tree& tree) {
  bool has_root = false;
  for (const auto& joints : tree.parents) {
    if (joints.size() > 1) return false;
    has_root = has_root || joints.empty();
  }
  return has_root;
}

bool has_root(const Tree& tree) {
  return std::any_of(tree.parents.begin(), tree.parents.end(),
                     [](const auto& joints) { return joints.empty(); });
}

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  const Tree tree = tree_of(root, context.frames(), robot);
  std::vector<std::string> links;
  const model::Joint* last = nullptr;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!tree.on_loop[i]) continue;
    links.push_back(root[robot.links[i]].name.value);
    for (const auto id : tree.parents[i]) {
      const auto& ends = context.frames().ends(id);
      // A joint from a link to itself is joint-parent-is-child.
      if (ends.parent != ends.child && (last == nullptr || last < &root[id])) last = &root[id];
    }
  }
  if (last == nullptr || links.size() < 2) return;
  context.report({.where = last->child.span,
                  .message = "joints make a loop of links: " + joined(links),
                  .subject = context.subject(*last),
                  .refused = !beside_tree(tree),
                  .why = has_root(tree) ? ""
                                        : "urdfdom rejects the robot: no link is its root, since "
                                          "each is the child of a joint."});
}

Rule rule() {
  return {
      .name = "kinematic-loop",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kSays},
      .formats = Formats::kUrdf,
      .summary = "the joints of a URDF make a loop",
      .why = "urdfdom accepts the loop, and walking the tree then never ends: check_urdf does not "
             "return, libsdformat overflows its stack. Where the loop leaves no link as the root, "
             "urdfdom rejects the robot. A URDF is a tree.",
      .what_to_do = "Take one of the joints out. URDF cannot close a chain; SDF can.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::kinematic_loop
