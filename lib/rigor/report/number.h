// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers as reports show them: independent of the locale, and without a negative zero.

#pragma once

#include <string>

#include <rigor/model/pose.h>

namespace rigor::report {

/// With this many significant digits, as printf's %g.
std::string number(double value, int digits);

/// Six digits, for people.
inline std::string number(double value) { return number(value, 6); }

/// "x y z"
std::string numbers(const model::Vector3& v, int digits);

/// The same rotation with w ≥ 0.
model::Quaternion positive_w(model::Quaternion q);

/// Roll, pitch and yaw in radians about the fixed x, y and z axes; roll is zero where only the sum
/// of roll and yaw is known (pitch ±π/2).
model::Vector3 to_rpy(const model::Quaternion& q);

}  // namespace rigor::report
