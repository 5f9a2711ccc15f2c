// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/frame/written_pose.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::quaternion_not_unit {

// Numbers with three digits are near enough.
constexpr double kTolerance = 0.002;

/// The last four numbers of the value, divided by their length.
std::optional<Fix> divided(const WrittenRotation& rotation, double length, const Context& context) {
  const std::string_view text = context.bytes(rotation.span);
  const std::size_t end = text.find_last_not_of(write::kSpace) + 1;
  std::size_t begin = end;
  for (int number = 0; number < 4; ++number) {
    const std::size_t last = text.find_last_not_of(write::kSpace, begin == 0 ? 0 : begin - 1);
    begin = text.find_last_of(write::kSpace, last) + 1;
  }
  std::vector<double> numbers = rotation.numbers;
  for (double& number : numbers) number /= length;
  const auto at = [&rotation](std::size_t offset) {
    return rotation.span.begin + static_cast<std::uint32_t>(offset);
  };
  return Fix{"divide by the length",
             Applicability::kSafe,
             {{{rotation.span.source, at(begin), at(end)}, write::joined(numbers)}}};
}

std::optional<Finding> check_pose(const model::PoseField& pose, const Context& context) {
  if (!pose.pose.written || !context.root().own(pose.site)) return std::nullopt;
  if (!rotation_format(pose, context).declared) return std::nullopt;
  const auto rotation = written_rotation(pose, context);
  if (!rotation || rotation->numbers.size() != 4 || rotation->degrees) return std::nullopt;
  double square = 0;
  for (const double number : rotation->numbers) square += number * number;
  const double length = std::sqrt(square);
  // Of the zero one quaternion-zero speaks.
  if (!std::isfinite(length) || length == 0 || std::abs(length - 1) < kTolerance) {
    return std::nullopt;
  }
  Finding finding{.where = rotation->span,
                  .message = fmt::format("the quaternion has the length {:.6g}, not 1", length)};
  if (rotation->verbatim) finding.fix = divided(*rotation, length, context);
  return finding;
}

Rule rule() {
  return {
      .name = "quaternion-not-unit",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kSafe,
      .summary = "the quaternion of a pose is not of length one",
      .why = "Only a quaternion of length one is a rotation. libsdformat divides by the length "
             "without a word; a mistyped number becomes another rotation, and who does not divide "
             "gets a body that is sheared.",
      .what_to_do = "Write x y z w so that their squares sum up to 1; w comes last.",
      .checks = on_poses<check_pose>(),
  };
}

}  // namespace rigor::rules::quaternion_not_unit
