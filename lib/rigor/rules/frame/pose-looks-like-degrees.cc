// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/frame/written_pose.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::pose_looks_like_degrees {

constexpr double kTurn = 6.283185307179586;
// 1 % over a full turn leaves room for 6.3 and the like.
constexpr double kMax = 1.01 * kTurn;

/// Whole numbers up to a turn are what people write in degrees, and multiples of five beyond.
bool round_degrees(double angle) {
  return std::fmod(angle, 5) == 0 || (std::abs(angle) <= 360 && std::fmod(angle, 1) == 0);
}

/// A full turn has two digits in degrees: most poses need no closer look.
bool has_long_number(std::string_view bytes) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  bool starts = true;
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
    const bool digit = is_digit(bytes[i]);
    if (digit && starts && is_digit(bytes[i + 1])) return true;
    starts = !digit && bytes[i] != '.';
  }
  return false;
}

std::optional<Finding> check_pose(const model::PoseField& pose, const Context& context) {
  if (!has_long_number(context.bytes(pose.pose.span))) return std::nullopt;
  const auto rotation = written_rotation(pose, context);
  if (!rotation || rotation->degrees || rotation->numbers.size() != 3) return std::nullopt;
  for (const double angle : rotation->numbers) {
    if (std::abs(angle) < kMax || !round_degrees(angle)) continue;
    return Finding{
        .where = rotation->span,
        .message = fmt::format(
            "the angle {0} looks like degrees: angles are in radians, and {0}° is {1:.6g} rad",
            angle, angle / 360 * kTurn)};
  }
  return std::nullopt;
}

Rule rule() {
  return {
      .name = "pose-looks-like-degrees",
      .severity = Severity::kWarning,
      .summary = "an angle of a pose looks like degrees",
      .why = "Read as radians, 90 is more than fourteen turns: the part is rotated wrongly, and "
             "no consumer warns. Angles are in radians unless degrees=\"true\" is set (SDF 1.9 "
             "and later).",
      .what_to_do = "Convert the angle to radians, or write degrees=\"true\" in an SDF 1.9 pose.",
      .checks = on_poses<check_pose>(),
  };
}

}  // namespace rigor::rules::pose_looks_like_degrees
