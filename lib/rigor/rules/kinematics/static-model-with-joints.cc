// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::static_model_with_joints {

void check(const model::Model& model, Context& context) {
  const model::Root& root = context.root();
  // An include may say so in another file.
  if (!model.is_static.value || model.is_static.span.source != root.source) return;
  const auto moves = [&root](model::Id<model::Joint> id) {
    return has_axis(root[id].type) || root[id].type == model::JointType::kBall;
  };
  const auto count = std::count_if(model.joints.begin(), model.joints.end(), moves);
  if (count == 0) return;
  const std::string joints = count == 1 ? "its joint" : fmt::format("its {} joints", count);
  context.report({.where = model.is_static.span,
                  .message = "the model is static: no force moves " + joints,
                  .subject = context.subject(model)});
}

Rule rule() {
  return {
      .name = "static-model-with-joints",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a static model has joints that move",
      .why = "The engine moves nothing of a static model: its joints, limits and springs are "
             "without effect, and plugins that push or turn the joints do nothing. Only a plugin "
             "that sets positions moves it.",
      .what_to_do =
          "Take <static> out and fix the model to the world by a joint, or take the joints out.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::static_model_with_joints
