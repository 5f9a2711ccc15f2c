// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <rigor/rules/kinematics/leader.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mimic_cycle {

using JointId = model::Id<model::Joint>;

enum class Visit : std::uint8_t { kNever, kThisTime, kDone };

/// Whom a joint follows; none where it moves on its own, or has two axes, which may differ.
JointId followed_by(const model::Root& root, const model::Frames& frames, JointId id) {
  const model::Joint& joint = root[id];
  if (joint.axes.size() != 1 || !joint.axes.front().mimic) return {};
  return leader_of(frames, joint, *joint.axes.front().mimic);
}

/// "a -> b -> a", or its beginning.
std::string circle_of(const model::Root& root, const model::Frames& frames, JointId first) {
  constexpr int kMaxNamed = 8;
  std::string circle = root[first].name.value;
  JointId at = first;
  for (int named = 0; named < kMaxNamed; ++named) {
    at = followed_by(root, frames, at);
    circle += " -> " + root[at].name.value;
    if (at == first) return circle;
  }
  return circle + " -> …";
}

void check(const model::Root& root, Context& context) {
  const auto follows = [](const model::Joint& joint) {
    return !joint.axes.empty() && joint.axes.front().mimic;
  };
  if (std::none_of(root.joints.begin(), root.joints.end(), follows)) return;
  std::vector<Visit> visits(root.joints.size(), Visit::kNever);
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    std::vector<JointId> way;
    JointId at{i};
    while (at && visits[at.value] == Visit::kNever) {
      visits[at.value] = Visit::kThisTime;
      way.push_back(at);
      at = followed_by(root, context.frames(), at);
    }
    const bool circle = at && visits[at.value] == Visit::kThisTime;
    for (const JointId id : way) visits[id.value] = Visit::kDone;
    if (!circle || !root.own(root[at].site)) continue;
    context.report(
        {.where = root[at].axes.front().mimic->joint.span,
         .message = "mimic joints form a cycle: " + circle_of(root, context.frames(), at),
         .subject = context.subject(root[at])});
  }
}

Rule rule() {
  return {
      .name = "mimic-cycle",
      .severity = Severity::kError,
      .summary = "mimic joints form a cycle",
      .why = "joint_state_publisher ends with \"Found an infinite recursive mimic chain\"; MoveIt "
             "ignores every mimic of the robot. None of their positions follows from one that is "
             "given.",
      .what_to_do = "Choose one joint as the leader, and remove its <mimic>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mimic_cycle
