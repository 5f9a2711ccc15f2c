// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/travel.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::limits_drive_into_parent {

// Shares of a link's own volume: boxes around bent shapes share some where the shapes do not.
constexpr double kInside = 0.3;
constexpr double kMore = 0.2;     // than at zero
constexpr double kBeside = 0.25;  // at zero

/// Where the child is inside of the parent.
struct Depth {
  double position = 0;  // of the joint, rad or m
  double inside = -1;   // share of the child
};

Depth deepest(const robot::JointSides& sides, const robot::Range& range) {
  Depth most;
  for (const double position : robot::positions_in(range)) {
    const double inside = sides.inside(position);
    if (inside > most.inside) most = {position, inside};
  }
  return most;
}

/// Whether any of it is inside where the range begins, ends or has its middle: elsewhere only then is it checked.
bool is_touched(const robot::JointSides& sides, const robot::Range& range) {
  constexpr double kTouched = 0.1;
  const double middle = (range.lower + range.upper) / 2;
  return sides.inside(range.upper) > kTouched || sides.inside(range.lower) > kTouched ||
         sides.inside(middle) > kTouched;
}

struct Entry {
  const model::Joint* joint = nullptr;
  robot::Range range;
  double at_zero = 0;
  Depth deepest;
  bool is_outside_mirrored = false;  // with the signs of its limits exchanged
};

void report(const Entry& found, Context& context) {
  const model::Joint& joint = *found.joint;
  const model::Axis& axis = joint.axes.front();
  const auto& [lower, upper] = found.range;
  const bool is_below = found.deepest.position - lower < upper - found.deepest.position;
  const model::Field<double>& limit = is_below ? axis.lower : axis.upper;
  // An arm that slides out of its sleeve is inside when it is in.
  const bool is_sign = found.is_outside_mirrored && joint.type == model::JointType::kRevolute;
  Finding finding{.where = limit.written ? limit.span : axis.limit_site.name,
                  .message = fmt::format(
                      "child '{}' is {:.0f} % inside parent '{}' at {:.3g} {}, within the "
                      "limits; {:.0f} % at zero",
                      joint.child.value, 100 * found.deepest.inside, joint.parent.value,
                      found.deepest.position, position_unit(joint.type), 100 * found.at_zero),
                  .subject = context.subject(joint),
                  .severity = is_sign ? Severity::kWarning : Severity::kInfo};
  if (is_sign) {
    finding.help = fmt::format(
        "Check the signs of the axis and of the limits: from {:.6g} to {:.6g} it stays outside",
        0 - upper, 0 - lower);
  }
  context.report(std::move(finding));
}

void check(const model::Root& root, Context& context) {
  constexpr std::size_t kMaxShapes = 600;
  const robot::Assembled& robot = context.assembled();
  if (robot.shapes.size() < 2 || robot.shapes.size() > kMaxShapes) return;
  const robot::RigidGroups rigid(root, context.frames(), robot);
  std::vector<Entry> found;
  for (std::uint32_t j = 0; j < root.joints.size(); ++j) {
    const model::Joint& joint = root.joints[j];
    const auto range = root.own(joint.site) ? robot::limited_range(joint) : std::nullopt;
    if (!range) continue;
    const auto sides = robot::sides_of({j}, root, context.frames(), robot, rigid);
    if (!sides) continue;
    if (!is_touched(*sides, *range)) continue;
    const double at_zero = sides->inside(0);
    if (at_zero > kBeside) continue;
    const Depth most = deepest(*sides, *range);
    if (most.inside < std::max(kInside, at_zero + kMore)) continue;
    const Depth mirrored = deepest(*sides, {-range->upper, -range->lower});
    found.push_back({&joint, *range, at_zero, most, mirrored.inside < at_zero + kMore / 2});
  }
  for (const Entry& one : found) {
    // More of them are how the robot is made, or drawn.
    constexpr std::ptrdiff_t kMax = 2;
    const auto beside = std::count_if(found.begin(), found.end(), [&one](const Entry& other) {
      return other.joint->model == one.joint->model;
    });
    if (beside <= kMax) report(one, context);
  }
}

Rule rule() {
  return {
      .name = "limits-drive-into-parent",
      .severity = Severity::kWarning,
      .summary = "joint limits let a link move into its parent",
      .why = "The link is beside its parent at zero, and much of it is inside the parent at a "
             "position that the limits allow. Simulators ignore contacts between a link and its "
             "parent by default, so nothing stops it there; MoveIt plans around the collision or "
             "reports that it begins in one. It is a warning where the opposite limits keep a "
             "revolute joint outside, as then the sign of the axis or the limits is wrong, and "
             "an info where they do not, or the link slides, as a telescope's does. Shapes are "
             "compared as boxes at nine positions, with all other joints at zero; three or more "
             "such joints are not reported.",
      .what_to_do = "Correct the sign, or narrow the limits to where the link is outside its "
                    "parent. `rigor inspect --assembled` prints how much of it is inside.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::limits_drive_into_parent
