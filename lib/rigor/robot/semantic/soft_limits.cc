// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/semantic/soft_limits.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace rigor::robot {

PositionRange within_soft_limits(const PositionRange& range, const model::Joint& joint) {
  if (!joint.safety || !joint.safety->soft_lower.written || !joint.safety->soft_upper.written)
    return range;
  const PositionRange narrow{std::max(range.lower, joint.safety->soft_lower.value),
                             std::min(range.upper, joint.safety->soft_upper.value)};
  return narrow.lower < narrow.upper ? narrow : range;
}

Robot within_soft_limits(Robot robot, const model::Root& root) {
  std::map<std::string_view, const model::Joint*> by_name;
  for (const model::Joint& joint : root.joints) {
    if (joint.safety) by_name.emplace(joint.name.value, &joint);
  }
  for (Joint& joint : robot.joints) {
    const auto found = by_name.find(joint.name);
    if (found == by_name.end() || joint.axes.size() != 1) continue;
    Axis& axis = joint.axes.front();
    const PositionRange range = within_soft_limits({axis.lower, axis.upper}, *found->second);
    axis.lower = range.lower;
    axis.upper = range.upper;
  }
  return robot;
}

}  // namespace rigor::robot
