// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How heavy a body is, and how its mass is spread: mass, center of mass and inertia tensor, with the
// algebra that moves and joins them and the verdict whether a rigid body can have them.
//
// Convention: the tensor's entries are those of the symmetric matrix, so ixy = -∫xy dm, as SDF, URDF
// and MuJoCo write them. Some CAD programs export the products of inertia ∫xy dm instead.
//
//   MassProperties whole = add(left, transformed(X_LR, right));
//   Verdict verdict = judge(whole);
//   if (!verdict.triangle.holds) say(verdict.triangle.sum, verdict.triangle.largest);
//
// Formulas: D. T. Greenwood, "Principles of Dynamics", 2nd ed., 1988, ch. 7 (parallel axes, rotation
// of axes, R I Rᵀ); P. C. Hughes, "Spacecraft Attitude Dynamics", 1986, §2.2 (moments of a body obey
// the triangle inequalities).

#pragma once

#include <array>
#include <string_view>

#include <rigor/model/pose.h>

namespace rigor::mass {

/// kg·m²; matrix entries. About which point and along which axes is said where it is used.
struct Inertia {
  double ixx = 0;
  double ixy = 0;
  double ixz = 0;
  double iyy = 0;
  double iyz = 0;
  double izz = 0;

  bool operator==(const Inertia&) const = default;
};

Inertia operator+(const Inertia& a, const Inertia& b);
Inertia operator-(const Inertia& a, const Inertia& b);
Inertia operator*(double factor, const Inertia& inertia);
double trace(const Inertia& inertia);

/// R I Rᵀ: the tensor along the axes of A, from that along the axes of B, given R_AB.
Inertia rotated(const model::Quaternion& R_AB, const Inertia& I_B);

/// What a point mass (kg) at `p` (m) has about the origin: m (|p|² 1 - p pᵀ).
Inertia point_inertia(double mass, const model::Vector3& p);

/// Moments about the principal axes, ascending, kg·m²; NaN where an entry is not finite.
std::array<double, 3> principal_moments(const Inertia& inertia);

/// Of the tensor's frame: Σ moments[i] axes[i] axes[i]ᵀ is the tensor.
struct PrincipalAxes {
  std::array<double, 3> moments{};  ///< ascending, kg·m²
  /// Unit vectors, right-handed. Of the first two the first component above kLeadingComponent in size
  /// is positive, so that the same tensor always has the same axes; where moments are equal, axes
  /// are as good as any.
  std::array<model::Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// A unit vector has a component of 0.577 at least, and those of angles that people draw (30°, 45°,
/// 60°) are not so near to 0.4 that rounding would flip the axis.
inline constexpr double kLeadingComponent = 0.4;

/// NaN moments where an entry is not finite.
PrincipalAxes principal_axes(const Inertia& inertia);

/// How far from each of three perpendicular axes the whole mass would have these moments (kg·m²), m:
/// √(I/m). Zero where there is no mass or the moment is negative.
std::array<double, 3> gyration_radii(double mass, const std::array<double, 3>& moments);

/// Sides of the box of even density that has these moments about its axes, m: √(6 (Iy + Iz - Ix)/m).
/// Zero where there is no mass, or the other two moments do not sum up to the third.
std::array<double, 3> equivalent_box(double mass, const std::array<double, 3>& moments);

struct MassProperties {
  double mass = 0;     ///< kg
  model::Vector3 com;  ///< m, in the link frame
  Inertia about_com;   ///< kg·m² about `com`, along the axes of the link frame

  bool operator==(const MassProperties&) const = default;
};

/// The same body described in frame A, from its description in frame B.
MassProperties transformed(const model::Pose& X_AB, const MassProperties& in_B);

/// The same body moved by `p`, m. (To turn it about the origin, transform it.)
MassProperties translated(const model::Vector3& p, const MassProperties& body);

/// The body with all lengths from the origin multiplied by `factor` > 0: at the same density it has
/// factor³ of the mass, else the same mass.
MassProperties scaled_at_density(double factor, const MassProperties& body);
MassProperties scaled_at_mass(double factor, const MassProperties& body);

/// The body at another density, such that it has this mass (kg). One without mass becomes a point.
MassProperties with_mass(const MassProperties& body, double mass);

/// Two bodies, described in one frame, as one rigid body. Two bodies without mass are one at the
/// origin.
MassProperties add(const MassProperties& a, const MassProperties& b);

/// What is left of a body after a part of it is taken out.
MassProperties subtract(const MassProperties& whole, const MassProperties& part);

/// The tensor about a point of the frame instead of the center of mass (parallel axes).
Inertia about(const model::Vector3& point, const MassProperties& body);
Inertia about_origin(const MassProperties& body);

/// nᵀ I n, kg·m²: the moment about an axis through the tensor's point, given as a unit vector. Of an
/// angular velocity (rad/s), twice the energy (J).
inline double moment_about(const model::Vector3& n, const Inertia& I) {
  return I.ixx * n.x * n.x + I.iyy * n.y * n.y + I.izz * n.z * n.z +
         2 * (I.ixy * n.x * n.y + I.ixz * n.x * n.z + I.iyz * n.y * n.z);
}

/// Below this share of the largest moment, a negative moment or a violated inequality is taken for
/// the rounding of the eigenvalue solver and of numbers written in full. It is no allowance for
/// numbers rounded to few digits: libsdformat refuses those (its own share is ten machine epsilons,
/// 2.2e-15), and says not which number is at fault.
inline constexpr double kTolerance = 1e-13;

/// Whether a rigid body can have a mass and tensor, with the numbers that say so.
struct Verdict {
  enum class Sign { kNegative, kZero, kPositive };

  bool mass_finite = true;
  bool tensor_finite = true;
  Sign mass_sign = Sign::kPositive;

  /// The rest means something only for a finite tensor.
  std::array<double, 3> principal{};  ///< ascending, kg·m²
  /// Of the smallest principal moment: zero is a rod or a point, negative is nothing at all.
  Sign smallest = Sign::kPositive;

  /// Two moments must sum up to the third at least. Spoken of in entries (ixx + iyy ≥ izz) where
  /// these already break it, else in principal moments.
  struct Triangle {
    bool holds = true;
    std::array<std::string_view, 3> names;  ///< of the two that are summed, and of the largest
    double sum = 0;                         ///< kg·m²
    double largest = 0;                     ///< kg·m²
  } triangle;

  /// About the principal axes, m; zero without mass.
  std::array<double, 3> gyration{};

  /// Whether no consumer has a reason to refuse: zero mass and singular tensors included. The same as
  /// the pseudo-inertia's being positive semidefinite (P. M. Wensing, S. Kim, J.-J. E. Slotine, "Linear
  /// matrix inequalities for physically consistent inertial parameter identification", RA-L 2018).
  bool possible() const {
    return mass_finite && tensor_finite && mass_sign != Sign::kNegative &&
           smallest != Sign::kNegative && triangle.holds;
  }
};

Verdict judge(double mass, const Inertia& inertia);
inline Verdict judge(const MassProperties& body) { return judge(body.mass, body.about_com); }

}  // namespace rigor::mass
