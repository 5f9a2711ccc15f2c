// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <unordered_set>

#include <rigor/rules/rule.h>

namespace rigor::rules::joint_end_is_model {

using ModelNames = std::unordered_set<std::string_view>;

ModelNames nested_names(const model::Model& around, const model::Root& root) {
  ModelNames names;
  for (const model::Id<model::Model> id : around.models) {
    if (!root[id].merged) names.insert(root[id].name.value);
  }
  return names;
}

/// Whether a name means a model and is refused for it: `__model__` and `arm::__model__` at both ends, and
/// as the parent `arm` too.
bool means_model(std::string_view name, bool is_parent, const ModelNames& nested) {
  return name == "__model__" || name.ends_with("::__model__") ||
         (is_parent && nested.contains(name));
}

// The reader that refuses this does not look at the joints of nested models, and those of a world came
// after it.
void check(const model::Model& around, Context& context) {
  const model::Root& root = context.root();
  if (around.parent || around.joints.empty()) return;
  const ModelNames nested = nested_names(around, root);
  for (const model::Id<model::Joint> id : around.joints) {
    const model::Joint& joint = root[id];
    if (!root.own(joint.site)) continue;
    for (const auto* end : {&joint.parent, &joint.child}) {
      const bool is_parent = end == &joint.parent;
      if (!end->written || !means_model(end->value, is_parent, nested)) continue;
      const std::string which = is_parent ? "parent" : "child";
      context.report({.where = end->span,
                      .message = "the " + which + " of the joint is a model, '" + end->value +
                                 "': Gazebo Fortress and older refuse that",
                      .subject = context.subject(joint),
                      .help = "name the link of the model that the joint holds on to"});
    }
  }
}

Rule rule() {
  return {
      .name = "joint-end-is-model",
      .severity = Severity::kWarning,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "the parent or child of a joint is a model",
      .why =
          "libsdformat 12 refuses the file (errors 19 and 20): it looks for a link, joint or frame "
          "of that name. Only as the child it takes the name of a nested model. Later ones take "
          "the model's frame, which moves with its canonical link; in nested models all do.",
      .what_to_do =
          "Name the link itself, as base or arm::base, or a frame that is attached to the model.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::joint_end_is_model
