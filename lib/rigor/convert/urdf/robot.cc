// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/robot.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <rigor/mass/mass_properties.h>
#include <rigor/schema/value.h>

namespace rigor::convert {
namespace {

using model::Pose;
using model::Vector3;

/// What a written pose may be off by, m and rad: a thousandth of what any reader compares with.
constexpr double kOriginTolerance = 1e-12;

/// Below this cosine of the pitch, roll and yaw turn about one axis as far as anybody can tell.
constexpr double kOriginGimbalCosine = 1e-9;

/// An angle this near to a quarter turn is one: the last bits of a product of rotations.
constexpr double kRpyNoise = 1e-14;

/// Beside a component this much larger another one is the noise of a rotation.
constexpr double kComponentNoise = 1e-15;

constexpr double kQuarterTurn = std::numbers::pi / 2;

double rounded_behind_point(double value, int decimals) {
  using Limits = std::numeric_limits<double>;
  std::array<char, Limits::max_exponent10 + 32> buffer;  // all digits before and behind a point
  char* const begin = buffer.data();
  const auto written =
      std::to_chars(begin, begin + buffer.size(), value, std::chars_format::fixed, decimals);
  std::from_chars(begin, written.ptr, value);
  return value + 0.0;  // of -0 this makes 0
}

/// Fifteen significant digits of the largest component; never so few that they move the pose by
/// more than kOriginTolerance, never so many that the noise of sums about a meter large is reported.
Vector3 rounded_translation(const Vector3& p) {
  constexpr int kFewestDecimals = 12;
  constexpr int kMaxDecimals = 14;
  const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!(size > 0) || !std::isfinite(size)) return p;
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  const int decimals = std::clamp(14 - magnitude, kFewestDecimals, kMaxDecimals);
  return {rounded_behind_point(p.x, decimals), rounded_behind_point(p.y, decimals),
          rounded_behind_point(p.z, decimals)};
}

double rounded_angle(double angle) {
  const double turn = kQuarterTurn * std::round(angle / kQuarterTurn);
  if (std::abs(angle - turn) <= kRpyNoise) return turn + 0.0;
  return rounded_behind_point(angle, 14);
}

/// The yaw that goes with a roll and R: what is left of R when the roll is undone has its second
/// column at (-sin yaw, cos yaw, 0), so that a roll known to a few digits only, as near a pitch of
/// ±90°, is made good by the yaw.
double yaw_of(const model::Matrix3& R, double roll) {
  const double c = std::cos(roll);
  const double s = std::sin(roll);
  return std::atan2(s * R[0][2] - c * R[0][1], c * R[1][1] - s * R[1][2]);
}

Vector3 rounded_rpy(const model::Matrix3& R, double roll) {
  const double pitch = std::atan2(-R[2][0], std::hypot(R[2][1], R[2][2]));
  return {rounded_angle(roll), rounded_angle(pitch), rounded_angle(yaw_of(R, roll))};
}

/// The greatest difference of two rotations' matrices, entry by entry.
double rotation_difference(const model::Matrix3& R, const Vector3& rpy) {
  const auto other = model::to_matrix(model::from_rpy(rpy.x, rpy.y, rpy.z));
  double most = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    most = std::max(most, std::abs(R[i / 3][i % 3] - other[i / 3][i % 3]));
  }
  return most;
}

Vector3 rpy_of(const model::Quaternion& q) {
  const model::Matrix3 R = model::to_matrix(model::normalized(q));
  if (std::hypot(R[2][1], R[2][2]) < kOriginGimbalCosine) {
    const Vector3 rpy = rounded_rpy(R, 0);
    if (rotation_difference(R, rpy) <= kOriginTolerance / 2) return rpy;
  }
  return rounded_rpy(R, std::atan2(R[2][1], R[2][2]));
}

Number3 as_numbers(const Vector3& v) { return {Number{v.x, {}}, Number{v.y, {}}, Number{v.z, {}}}; }

/// A text that every reader of URDF and SDF takes: decimal and finite, and no zero with a sign.
bool usable_text(const Number& number) {
  if (number.text.empty() || (number.value == 0 && number.text.find('-') == 0)) return false;
  const schema::NumberForm form = schema::classify(number.text);
  return !form.infinite && !form.nan && !form.hexadecimal && !form.leading_plus;
}

}  // namespace

std::string to_text(const Number& number) {
  if (usable_text(number)) return number.text;
  if (std::isnan(number.value) || number.value == 0) return "0";
  constexpr double kMax = std::numeric_limits<double>::max();
  std::string text = schema::to_shortest(std::clamp(number.value, -kMax, kMax));
  std::erase(text, '+');  // 1e+16
  return text;
}

Number3 numbers(const Vector3& v) {
  const double noise = kComponentNoise * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const auto clean = [noise](double value) { return std::abs(value) <= noise ? 0 : value; };
  return as_numbers({clean(v.x), clean(v.y), clean(v.z)});
}

UrdfOrigin origin_of(const Pose& X) {
  return {as_numbers(rounded_translation(X.translation)), as_numbers(rpy_of(X.rotation))};
}

std::array<Number, 6> tensor_entries(const mass::Inertia& I) {
  return {Number{I.ixx, {}}, Number{I.ixy, {}}, Number{I.ixz, {}},
          Number{I.iyy, {}}, Number{I.iyz, {}}, Number{I.izz, {}}};
}

UrdfInertial inertial_of(const mass::MassProperties& body) {
  return {origin_of({body.com, {}}), {body.mass, {}}, tensor_entries(body.about_com)};
}

bool is_identity(const UrdfOrigin& origin) {
  const auto zero = [](const Number& number) { return number.value == 0; };
  return std::all_of(origin.xyz.begin(), origin.xyz.end(), zero) &&
         std::all_of(origin.rpy.begin(), origin.rpy.end(), zero);
}

Pose pose_of(const UrdfOrigin& origin) {
  const auto& [x, y, z] = origin.xyz;
  const auto& [roll, pitch, yaw] = origin.rpy;
  return {{x.value, y.value, z.value}, model::from_rpy(roll.value, pitch.value, yaw.value)};
}

}  // namespace rigor::convert
