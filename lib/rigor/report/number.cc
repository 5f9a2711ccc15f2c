// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/number.h>

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace rigor::report {
namespace {

/// Sine of the pitch from which on roll and yaw are distinguished by rounding errors only.
constexpr double kGimbalSine = 1 - 1e-12;

}  // namespace

std::string number(double value, int digits) {
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

std::string numbers(const model::Vector3& v, int digits) {
  return number(v.x, digits) + ' ' + number(v.y, digits) + ' ' + number(v.z, digits);
}

model::Quaternion positive_w(model::Quaternion q) {
  return q.w < 0 ? model::Quaternion{-q.w, -q.x, -q.y, -q.z} : q;
}

model::Vector3 to_rpy(const model::Quaternion& q) {
  const model::Matrix3 R = model::to_matrix(q);
  const double sine = std::clamp(-R[2][0], -1.0, 1.0);
  if (std::abs(sine) > kGimbalSine) return {0, std::asin(sine), std::atan2(-R[0][1], R[1][1])};
  return {std::atan2(R[2][1], R[2][2]), std::asin(sine), std::atan2(R[1][0], R[0][0])};
}

}  // namespace rigor::report
