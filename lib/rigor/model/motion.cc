// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/motion.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::model {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Up to this version of SDF zero is the default of an effort and a velocity, and so no limit.
constexpr int kLastWithZeroUnlimited = 3;

/// From this version of SDF there is `<screw_thread_pitch>`.
constexpr int kScrewThreadPitch = 10;

double limit_of(const Root& root, const Joint& joint, const Field<double>& field) {
  const bool zero_is_none = joint.model && root[joint.model].format == Format::kSdf &&
                            root[joint.model].version <= kLastWithZeroUnlimited;
  if (!field.written || (zero_is_none && field.value == 0)) return kNoLimit;
  return magnitude_limit(field.value);
}

}  // namespace

double position_limit(double value) {
  if (value >= kUnlimited) return kNoLimit;
  return value <= -kUnlimited ? -kNoLimit : value;
}

// A comparison with nan is false, so no consumer clamps to it.
double magnitude_limit(double value) { return value >= 0 ? position_limit(value) : kNoLimit; }

double effort_limit(const Root& root, const Joint& joint, const Axis& axis) {
  return limit_of(root, joint, axis.effort);
}

double velocity_limit(const Root& root, const Joint& joint, const Axis& axis) {
  return limit_of(root, joint, axis.velocity);
}

double screw_lead(const Root& root, const Joint& joint) {
  const bool per_turn = joint.model && root[joint.model].version >= kScrewThreadPitch;
  if (joint.screw_thread_pitch.written || (per_turn && !joint.thread_pitch.written)) {
    return joint.screw_thread_pitch.value / (2 * std::numbers::pi);
  }
  const double radians_per_meter = joint.thread_pitch.value;
  if (radians_per_meter == 0 || !std::isfinite(radians_per_meter)) return 0;
  return -1 / radians_per_meter;
}

}  // namespace rigor::model
