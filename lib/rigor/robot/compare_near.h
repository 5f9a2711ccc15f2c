// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// When numbers and poses count as the same; private to the room.

#pragma once

#include <rigor/robot/compare.h>

namespace rigor::robot {

/// How far two poses are apart.
struct Apart {
  double distance = 0;  ///< m
  double angle = 0;     ///< rad
};

/// Zero for poses that are the same in every bit, even such as are not finite.
Apart apart(const model::Pose& a, const model::Pose& b);

/// `reach` (m) is how far from the origin it is: rounding grows with it.
bool within(const Apart& apart, const Tolerance& tolerance, double reach);
bool near(const model::Pose& a, const model::Pose& b, const Tolerance& tolerance);
bool near(const model::Vector3& a, const model::Vector3& b, const Tolerance& tolerance);

/// Relative to the greater of both; infinities of one sign are the same, and
/// NaN is the same as NaN.
bool near(double a, double b, const Tolerance& tolerance);
/// Relative to the tensor's size, since zero products of inertia come out of
/// rotations as rounding.
bool near(const mass::Inertia& a, const mass::Inertia& b, const Tolerance& tolerance);

bool near(const Shape& a, const Shape& b, const Tolerance& tolerance);
/// Whether two shapes take their triangles or heights from the same file.
bool same_file(const Shape& a, const Shape& b);

}  // namespace rigor::robot
