// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses and masses for the judges of conversions, written anew: a mistake that the library's own
// arithmetic makes must not be made here as well.
//
//   Rigid X_AC = X_AB * X_BC;
//   MassSum sum; sum.add(X_WL, mass, com, inertia);

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor::judge {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

inline constexpr Matrix kIdentity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Matrix transposed(const Matrix& a) {
  Matrix b{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) b[i][j] = a[j][i];
  }
  return b;
}
inline Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
  }
  return c;
}
inline Triple operator*(const Matrix& a, const Triple& v) {
  Triple w{};
  for (std::size_t i = 0; i < 3; ++i) w[i] = a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2];
  return w;
}
inline Triple operator+(const Triple& a, const Triple& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Triple operator-(const Triple& a, const Triple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Triple operator*(double s, const Triple& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double length(const Triple& a) { return std::hypot(a[0], a[1], a[2]); }

/// A pose, or a motion.
struct Rigid {
  Matrix R = kIdentity;
  Triple p{};
};

inline Rigid operator*(const Rigid& a, const Rigid& b) { return {a.R * b.R, a.R * b.p + a.p}; }

inline Rigid inverse(const Rigid& a) {
  const Matrix R = transposed(a.R);
  return {R, -1.0 * (R * a.p)};
}

/// The quaternion need not be of unit length.
inline Matrix rotation_of(double w, double x, double y, double z) {
  const double s = 2 / (w * w + x * x + y * y + z * z);
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

/// About a unit axis (Rodrigues).
inline Matrix turned(const Triple& axis, double angle) {
  const Matrix K{{{0, -axis[2], axis[1]}, {axis[2], 0, -axis[0]}, {-axis[1], axis[0], 0}}};
  const Matrix KK = K * K;
  Matrix R = kIdentity;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      R[i][j] += std::sin(angle) * K[i][j] + (1 - std::cos(angle)) * KK[i][j];
    }
  }
  return R;
}

/// How far two poses are apart: the greater of meters and radians. A distance counts per meter from
/// the origin beyond the first.
inline double apart(const Rigid& a, const Rigid& b) {
  const double meters = length(a.p - b.p) / std::max(1.0, length(a.p));
  const Matrix D = transposed(a.R) * b.R;
  const Triple twice_sine{D[2][1] - D[1][2], D[0][2] - D[2][0], D[1][0] - D[0][1]};
  const double radians = std::atan2(length(twice_sine) / 2, (D[0][0] + D[1][1] + D[2][2] - 1) / 2);
  return std::max(meters, radians);
}

/// What lumping does not change: Σ m, Σ m c and Σ of inertia about the origin.
struct MassSum {
  double mass = 0;   ///< kg
  Triple first{};    ///< kg·m
  Matrix second{};   ///< kg·m²
  double reach = 0;  ///< kg·m: Σ m |c|, to measure `first` by

  /// Mass at `com` and inertia about it, both in the frame that X is the pose of.
  void add(const Rigid& X, double m, const Triple& com, const Matrix& inertia) {
    const Triple c = X.R * com + X.p;
    const Matrix I = X.R * inertia * transposed(X.R);
    const double cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    mass += m;
    reach += m * length(c);
    first = first + m * c;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        second[i][j] += I[i][j] + m * ((i == j ? cc : 0) - c[i] * c[j]);
      }
    }
  }
};

/// The greatest relative difference.
inline double apart(const MassSum& a, const MassSum& b) {
  const auto relative = [](double difference, double size) {
    return difference == 0 ? 0 : std::abs(difference) / size;
  };
  const double size = std::abs(a.second[0][0] + a.second[1][1] + a.second[2][2]);
  double worst = std::max(relative(a.mass - b.mass, a.mass),
                          relative(length(a.first - b.first), std::max(a.reach, a.mass)));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      worst = std::max(worst, relative(a.second[i][j] - b.second[i][j], size));
    }
  }
  return worst;
}

}  // namespace rigor::judge
