// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mass_properties.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace rigor::mass {
namespace {

using model::Vector3;

Eigen::Matrix3d to_eigen(const Inertia& i) {
  Eigen::Matrix3d matrix;
  matrix << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  return matrix;
}

bool finite(const Inertia& i) { return to_eigen(i).allFinite(); }

Verdict::Sign sign(double value, double tolerance) {
  if (value > tolerance) return Verdict::Sign::kPositive;
  return value < -tolerance ? Verdict::Sign::kNegative : Verdict::Sign::kZero;
}

/// The axis or its opposite, whichever PrincipalAxes promises.
Vector3 facing_forward(const Vector3& axis) {
  for (const double component : {axis.x, axis.y, axis.z}) {
    if (std::abs(component) > kLeadingComponent) return component < 0 ? -1 * axis : axis;
  }
  return axis;
}

double length_of(double moment, double mass) {
  return mass > 0 && moment > 0 ? std::sqrt(moment / mass) : 0;
}

/// The largest of three moments against the sum of the other two.
Verdict::Triangle triangle(std::array<double, 3> moments, std::array<std::string_view, 3> names,
                           double tolerance) {
  const auto largest = std::max_element(moments.begin(), moments.end()) - moments.begin();
  std::rotate(moments.begin() + largest, moments.begin() + largest + 1, moments.end());
  std::rotate(names.begin() + largest, names.begin() + largest + 1, names.end());
  const double sum = moments[0] + moments[1];
  return {sum >= moments[2] - tolerance, names, sum, moments[2]};
}

}  // namespace

Inertia operator+(const Inertia& a, const Inertia& b) {
  return {a.ixx + b.ixx, a.ixy + b.ixy, a.ixz + b.ixz, a.iyy + b.iyy, a.iyz + b.iyz, a.izz + b.izz};
}

Inertia operator-(const Inertia& a, const Inertia& b) { return a + -1 * b; }

Inertia operator*(double factor, const Inertia& i) {
  return {factor * i.ixx, factor * i.ixy, factor * i.ixz,
          factor * i.iyy, factor * i.iyz, factor * i.izz};
}

double trace(const Inertia& inertia) { return inertia.ixx + inertia.iyy + inertia.izz; }

Inertia rotated(const model::Quaternion& R_AB, const Inertia& I_B) {
  // An exact identity keeps the entries as they are written, to the last bit.
  if (R_AB == model::Quaternion{}) return I_B;
  const model::Matrix3 rows = model::to_matrix(R_AB);
  Eigen::Matrix3d R;
  R << rows[0][0], rows[0][1], rows[0][2], rows[1][0], rows[1][1], rows[1][2], rows[2][0],
      rows[2][1], rows[2][2];
  const Eigen::Matrix3d I_A = R * to_eigen(I_B) * R.transpose();
  return {I_A(0, 0), I_A(0, 1), I_A(0, 2), I_A(1, 1), I_A(1, 2), I_A(2, 2)};
}

Inertia point_inertia(double mass, const Vector3& p) {
  return {mass * (p.y * p.y + p.z * p.z), -mass * p.x * p.y, -mass * p.x * p.z,
          mass * (p.x * p.x + p.z * p.z), -mass * p.y * p.z, mass * (p.x * p.x + p.y * p.y)};
}

std::array<double, 3> principal_moments(const Inertia& inertia) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  if (!finite(inertia)) return {kNan, kNan, kNan};
  if (inertia.ixy == 0 && inertia.ixz == 0 && inertia.iyz == 0) {
    std::array<double, 3> moments{inertia.ixx, inertia.iyy, inertia.izz};
    std::sort(moments.begin(), moments.end());
    return moments;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(to_eigen(inertia),
                                                              Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = solver.eigenvalues();
  return {moments[0], moments[1], moments[2]};
}

PrincipalAxes principal_axes(const Inertia& inertia) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  PrincipalAxes result{.moments = {kNan, kNan, kNan}};
  if (!finite(inertia)) return result;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(to_eigen(inertia));
  for (int i = 0; i < 3; ++i) {
    const auto axis = solver.eigenvectors().col(i);
    const auto k = static_cast<std::size_t>(i);
    result.moments[k] = solver.eigenvalues()[i];
    result.axes[k] = facing_forward({axis[0], axis[1], axis[2]});
  }
  result.axes[2] = model::cross(result.axes[0], result.axes[1]);
  return result;
}

std::array<double, 3> gyration_radii(double mass, const std::array<double, 3>& moments) {
  return {length_of(moments[0], mass), length_of(moments[1], mass), length_of(moments[2], mass)};
}

std::array<double, 3> equivalent_box(double mass, const std::array<double, 3>& moments) {
  const auto [x, y, z] = moments;
  return {length_of(6 * (y + z - x), mass), length_of(6 * (x + z - y), mass),
          length_of(6 * (x + y - z), mass)};
}

MassProperties translated(const Vector3& p, const MassProperties& body) {
  return {body.mass, body.com + p, body.about_com};
}

MassProperties scaled_at_density(double factor, const MassProperties& body) {
  return with_mass(scaled_at_mass(factor, body), factor * factor * factor * body.mass);
}

MassProperties scaled_at_mass(double factor, const MassProperties& body) {
  return {body.mass, factor * body.com, factor * factor * body.about_com};
}

MassProperties with_mass(const MassProperties& body, double mass) {
  return {mass, body.com, (body.mass == 0 ? 0 : mass / body.mass) * body.about_com};
}

MassProperties transformed(const model::Pose& X_AB, const MassProperties& in_B) {
  return {in_B.mass, model::transform(X_AB, in_B.com), rotated(X_AB.rotation, in_B.about_com)};
}

MassProperties add(const MassProperties& a, const MassProperties& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0) return {0, {}, a.about_com + b.about_com};
  const Vector3 com = (a.mass / mass) * a.com + (b.mass / mass) * b.com;
  return {mass, com,
          a.about_com + point_inertia(a.mass, a.com - com) + b.about_com +
              point_inertia(b.mass, b.com - com)};
}

MassProperties subtract(const MassProperties& whole, const MassProperties& part) {
  return add(whole, {-part.mass, part.com, -1 * part.about_com});
}

Inertia about(const Vector3& point, const MassProperties& body) {
  return body.about_com + point_inertia(body.mass, body.com - point);
}

Inertia about_origin(const MassProperties& body) { return about({}, body); }

Verdict judge(double mass, const Inertia& inertia) {
  Verdict verdict;
  verdict.mass_finite = std::isfinite(mass);
  verdict.tensor_finite = finite(inertia);
  if (verdict.mass_finite) verdict.mass_sign = sign(mass, 0);
  if (!verdict.tensor_finite) return verdict;
  verdict.principal = principal_moments(inertia);
  const double smallest = verdict.principal[0];
  const double largest = verdict.principal[2];
  const double tolerance = kTolerance * std::max(std::abs(smallest), std::abs(largest));
  verdict.smallest = sign(smallest, tolerance);
  verdict.gyration = gyration_radii(mass, verdict.principal);
  verdict.triangle =
      triangle({inertia.ixx, inertia.iyy, inertia.izz}, {"ixx", "iyy", "izz"}, tolerance);
  if (verdict.triangle.holds) {
    verdict.triangle = triangle(verdict.principal, {"I1", "I2", "I3"}, tolerance);
  }
  return verdict;
}

}  // namespace rigor::mass
