// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::effort_looks_like_kilonewtons {

constexpr double kKilo = 1000;

// N·m or N: from here on both may be right, as of an arm of 2000 N·m with fingers of 2.
constexpr double kMax = 1;

// Numbers are copied with all their digits.
constexpr double kSame = 1e-6;

/// Another joint's effort that is this one in newtons, when this one is written in kilonewtons.
std::optional<double> twin(double effort, const std::vector<double>& others) {
  for (const double other : others) {
    if (std::abs(effort * kKilo - other) < kSame * other) return other;
  }
  return std::nullopt;
}

void check(const model::Model& robot, Context& context) {
  const model::Root& root = context.root();
  std::vector<double> efforts;
  for (const auto id : robot.joints) {
    const model::Joint& joint = root[id];
    if (!has_axis(joint.type) || joint.axes.empty() || !joint.axes.front().effort.written) continue;
    efforts.push_back(joint.axes.front().effort.value);
  }
  if (efforts.size() < 2) return;
  for (const auto id : robot.joints) {
    const model::Joint& joint = root[id];
    if (!root.own(joint.site) || !has_axis(joint.type) || joint.axes.empty()) continue;
    const auto& effort = joint.axes.front().effort;
    if (!effort.written || !(effort.value > 0) || !(effort.value < kMax)) continue;
    const auto meant = twin(effort.value, efforts);
    if (!meant) continue;
    context.report({.where = effort.span,
                    .message = fmt::format(
                        "the effort limit of {0:.6g} {1} is a thousandth of the {2:.6g} {1} of "
                        "other joints",
                        effort.value, effort_unit(joint.type), *meant),
                    .subject = context.subject(joint),
                    .fix = Fix{"write that of the others",
                               Applicability::kUnsafe,
                               {{effort.span, write::joined({*meant})}}}});
  }
}

Rule rule() {
  return {
      .name = "effort-looks-like-kilonewtons",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a joint's effort limit is exactly a thousandth of another's",
      .why = "Read in N·m, or N of a prismatic joint, such a motor moves nothing: simulators "
             "clamp commands to the limit. An effort is reported when it is that of another joint "
             "of the robot over 1000 and below 1, as when one data sheet has kN·m and another N·m.",
      .what_to_do = "Write the effort in N·m, or N.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::effort_looks_like_kilonewtons
