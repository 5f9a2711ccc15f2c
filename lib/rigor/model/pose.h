// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Positions, rotations and poses as small plain values, so that including a model costs nothing to
// compile. Whoever needs linear algebra maps them to Eigen in a source file.
//
// Names follow the monogram notation: `X_WL` is the pose of L in W, and X_WL * X_LC = X_WC.
//
//   Pose X_ML = compose(X_MJ, X_JL);
//   Vector3 axis_M = rotate(X_MJ.rotation, axis_J);

#pragma once

#include <array>

namespace rigor::model {

struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

// Here, since they are called for each triangle of a million.
inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector3 operator*(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
inline double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double length(const Vector3& v);

/// Unit quaternion; w first, as `inspect` prints it (SDF's quat_xyzw writes it last).
struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Quaternion&) const = default;
};

/// Rows of a rotation or of a symmetric tensor.
using Matrix3 = std::array<std::array<double, 3>, 3>;

Quaternion operator*(const Quaternion& a, const Quaternion& b);
inline Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }
Quaternion normalized(const Quaternion& q);  ///< the identity for a zero quaternion
inline Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const Vector3 u{q.x, q.y, q.z};
  const Vector3 t = 2 * cross(u, v);
  return v + q.w * t + cross(u, t);
}
Matrix3 to_matrix(const Quaternion& q);

/// Roll, pitch and yaw in radians about the fixed x, y and z axes, in this order: R = Rz Ry Rx.
Quaternion from_rpy(double roll, double pitch, double yaw);

/// Rotation by `angle` radians about `axis`, which need not be a unit vector but not zero either.
Quaternion from_axis_angle(const Vector3& axis, double angle);

/// Brings x, y and z to these: right-handed unit vectors (S. W. Shepperd, "Quaternion from rotation matrix", Journal of
/// Guidance and Control 1, 1978).
Quaternion from_axes(const Vector3& x, const Vector3& y, const Vector3& z);

/// The pose of B in A: translation p_AB in meters, in A's axes, and rotation R_AB.
struct Pose {
  Vector3 translation;
  Quaternion rotation;

  bool operator==(const Pose&) const = default;
};

Pose compose(const Pose& X_AB, const Pose& X_BC);  ///< X_AC
Pose inverse(const Pose& X_AB);                    ///< X_BA
Vector3 transform(const Pose& X_AB, const Vector3& p_B);

}  // namespace rigor::model
