// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_range_looks_like_radians {

constexpr double kTurn = 6.283185307179586;
constexpr double kDegree = kTurn / 360;

/// As it is written, of a hinge that is limited in degrees; nothing of any other joint.
std::vector<double> range_in_degrees(const model::Joint& joint, const Context& context) {
  if (joint.type != model::JointType::kRevolute || joint.axes.empty()) return {};
  const model::Axis& axis = joint.axes.front();
  if (!axis.lower.written) return {};
  const auto range = read::mjcf_numbers(context.bytes(axis.lower.span));
  if (!range || range->size() != 2) return {};
  const double width = (*range)[1] - (*range)[0];
  const double read = axis.upper.value - axis.lower.value;
  return std::abs(width * kDegree - read) < 1e-6 * width ? *range : std::vector<double>();
}

/// What nobody writes who means degrees: 1.57, -2.6.
bool looks_like_radians(double angle) {
  constexpr double kMin = 0.5;
  return std::abs(angle) >= kMin && std::fmod(angle, 1) != 0;
}

void check(const model::Root& root, Context& context) {
  std::vector<const model::Joint*> found;
  bool any = false;
  for (const model::Joint& joint : root.joints) {
    const std::vector<double> range = range_in_degrees(joint, context);
    if (range.empty()) continue;
    for (const double limit : range) {
      if (std::abs(limit) > kTurn) return;  // these are degrees
      any = any || looks_like_radians(limit);
    }
    found.push_back(&joint);
  }
  if (!any) return;
  for (const model::Joint* joint : found) {
    const model::Axis& axis = joint->axes.front();
    context.report({.where = axis.lower.span,
                    .message = fmt::format("range {} looks like radians and is read in degrees",
                                           context.bytes(axis.lower.span)),
                    .subject = context.subject(*joint),
                    .cause = "angle"});
  }
}

Rule rule() {
  return {
      .name = "mjcf-range-looks-like-radians",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "all ranges of hinges look like radians, and are degrees",
      .why = "MuJoCo reads angles in degrees unless <compiler> says angle=\"radian\": the joints "
             "hardly move. It is reported where no hinge of the file reaches beyond 6.28, and one "
             "of the limits is no whole number.",
      .what_to_do = "Write <compiler angle=\"radian\"/>, which is for all angles of the file, or "
                    "write the ranges in degrees.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mjcf_range_looks_like_radians
