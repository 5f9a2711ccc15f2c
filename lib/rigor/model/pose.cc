// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/pose.h>

#include <cmath>

namespace rigor::model {

double length(const Vector3& v) { return std::hypot(v.x, v.y, v.z); }

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion normalized(const Quaternion& q) {
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (norm == 0) return {};
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

Matrix3 to_matrix(const Quaternion& q) {
  const Vector3 x = rotate(q, {1, 0, 0});
  const Vector3 y = rotate(q, {0, 1, 0});
  const Vector3 z = rotate(q, {0, 0, 1});
  return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
}

Quaternion from_rpy(double roll, double pitch, double yaw) {
  const Quaternion about_x{std::cos(roll / 2), std::sin(roll / 2), 0, 0};
  const Quaternion about_y{std::cos(pitch / 2), 0, std::sin(pitch / 2), 0};
  const Quaternion about_z{std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
  return about_z * (about_y * about_x);
}

Quaternion from_axis_angle(const Vector3& axis, double angle) {
  const Vector3 u = (std::sin(angle / 2) / length(axis)) * axis;
  return {std::cos(angle / 2), u.x, u.y, u.z};
}

Quaternion from_axes(const Vector3& x, const Vector3& y, const Vector3& z) {
  // The largest of the four components first, so that none is divided by little.
  const double trace = x.x + y.y + z.z;
  if (trace > 0) {
    const double s = 2 * std::sqrt(1 + trace);
    return {s / 4, (y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s};
  }
  if (x.x >= y.y && x.x >= z.z) {
    const double s = 2 * std::sqrt(1 + x.x - y.y - z.z);
    return {(y.z - z.y) / s, s / 4, (y.x + x.y) / s, (z.x + x.z) / s};
  }
  if (y.y >= z.z) {
    const double s = 2 * std::sqrt(1 + y.y - x.x - z.z);
    return {(z.x - x.z) / s, (y.x + x.y) / s, s / 4, (z.y + y.z) / s};
  }
  const double s = 2 * std::sqrt(1 + z.z - x.x - y.y);
  return {(x.y - y.x) / s, (z.x + x.z) / s, (z.y + y.z) / s, s / 4};
}

Pose compose(const Pose& X_AB, const Pose& X_BC) {
  return {transform(X_AB, X_BC.translation), normalized(X_AB.rotation * X_BC.rotation)};
}

Pose inverse(const Pose& X_AB) {
  const Quaternion R_BA = conjugate(X_AB.rotation);
  return {rotate(R_BA, -1 * X_AB.translation), R_BA};
}

Vector3 transform(const Pose& X_AB, const Vector3& p_B) {
  return X_AB.translation + rotate(X_AB.rotation, p_B);
}

}  // namespace rigor::model
