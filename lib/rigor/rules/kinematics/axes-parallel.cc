// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>

namespace rigor::rules::axes_parallel {

constexpr double kMinSine = 1e-3;

void check(const model::Joint& joint, Context& context) {
  if (joint.type != model::JointType::kUniversal && joint.type != model::JointType::kRevolute2) {
    return;
  }
  if (joint.axes.size() != 2 || !joint.axes[1].xyz.written) return;
  const model::Axis& first = joint.axes[0];
  const model::Axis& second = joint.axes[1];
  if (first.expressed_in.value != second.expressed_in.value) return;
  const model::Vector3& a = first.xyz.value;
  const model::Vector3& b = second.xyz.value;
  const double lengths = length(a) * length(b);
  if (!(lengths > 0)) return;  // axis-zero says so
  const model::Vector3 cross{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  if (!(length(cross) < kMinSine * lengths)) return;
  context.report({.where = second.xyz.span,
                  .message = "both axes of the " + std::string(to_string(joint.type)) +
                             " joint point the same way",
                  .subject = context.subject(joint),
                  .related = {{first.xyz.span, "the first axis"}}});
}

Rule rule() {
  return {
      .name = "axes-parallel",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "the two axes of a joint are the same",
      .why = "With parallel axes it is a revolute joint with a redundant angle: only the sum of "
             "the two is determined. A universal joint rotates about two axes that cross.",
      .what_to_do = "Write the second axis at a right angle to the first.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::axes_parallel
