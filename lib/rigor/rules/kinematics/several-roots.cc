// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <set>
#include <string_view>

#include <rigor/rules/kinematics/tree.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::several_roots {

/// Links that are named in place of another by a joint, which two-parents reports.
std::set<const model::Link*> misnamed_children(const Tree& tree, const model::Model& robot,
                                               const model::Root& root) {
  std::set<const model::Link*> links;
  for (const auto& joints : tree.parents) {
    for (std::size_t k = 0; joints.size() > 1 && k < joints.size(); ++k) {
      links.insert(misnamed_child(root[joints[k]], tree, robot, root));
    }
  }
  return links;
}

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  const Tree tree = tree_of(root, context.frames(), robot);
  if (!tree.complete) return;  // a link whose joint does not exist is no second root
  const model::Link* first = nullptr;
  std::set<std::string_view> names;
  const auto misnamed = misnamed_children(tree, robot, root);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const model::Link& link = root[robot.links[i]];
    // Of two links of one name the joints mean the first: the second is another rule's affair.
    const bool repeated = !names.insert(link.name.value).second;
    if (repeated || !tree.parents[i].empty() || misnamed.contains(&link)) continue;
    if (first == nullptr) {
      first = &link;
      continue;
    }
    context.report({.where = link.site.name,
                    .message = "the link '" + link.name.value +
                               "' is the child of no joint, and neither is '" + first->name.value +
                               "': a robot has one root",
                    .subject = context.subject(link),
                    .related = {{first->site.name, "the first root"}}});
  }
}

Rule rule() {
  return {
      .name = "several-roots",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .summary = "a URDF has more than one root link",
      .why = "urdfdom rejects the robot: every link but one must be the child of a joint.",
      .what_to_do = "Connect the link by a joint (a fixed one, if it does not move), or remove it.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::several_roots
