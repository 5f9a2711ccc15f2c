// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>

#include <rigor/rules/edits.h>
#include <rigor/rules/frame/written_pose.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::quaternion_zero {

/// The last of seven numbers becomes a one.
std::optional<Fix> unit_quaternion(const WrittenRotation& rotation, const Context& context) {
  const std::string_view text = context.bytes(rotation.span);
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  const std::size_t w = text.find_last_of(" \t\r\n", last) + 1;
  const auto at = [&rotation](std::size_t offset) {
    return rotation.span.begin + static_cast<std::uint32_t>(offset);
  };
  const Span number{rotation.span.source, at(w), at(last + 1)};
  return Fix{"write no rotation", Applicability::kSafe, {{number, "1"}}};
}

std::optional<Finding> check_pose(const model::PoseField& pose, const Context& context) {
  // A zero quaternion is read as no rotation, so only that needs a closer look.
  if (!pose.pose.written || !(pose.pose.value.rotation == model::Quaternion{})) return std::nullopt;
  if (!rotation_format(pose, context).declared) return std::nullopt;
  const auto rotation = written_rotation(pose, context);
  if (!rotation || rotation->numbers.size() != 4) return std::nullopt;
  const auto zero = [](double number) { return number == 0; };
  if (!std::all_of(rotation->numbers.begin(), rotation->numbers.end(), zero)) return std::nullopt;
  return Finding{.where = rotation->span,
                 .message = "the quaternion 0 0 0 0 is no rotation; it is taken for none",
                 .help = "write 0 0 0 1 (x y z w) for no rotation",
                 .fix = unit_quaternion(*rotation, context)};
}

Rule rule() {
  return {
      .name = "quaternion-zero",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kSafe,
      .summary = "the quaternion of a pose is zero",
      .why = "libsdformat takes the zero one for no rotation silently. A rotation is a quaternion "
             "of length one.",
      .what_to_do = "Write 0 0 0 1 where nothing is turned; w comes last.",
      .checks = on_poses<check_pose>(),
  };
}

}  // namespace rigor::rules::quaternion_zero
