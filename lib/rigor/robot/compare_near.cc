// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/compare_near.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <rigor/text/path.h>

namespace rigor::robot {
namespace {

/// m: from here on a distance is judged relative to the reach. A rotation that
/// is off by one rounding (1e-16) moves what is a kilometer away by 1e-13 m;
/// long chains add up thousands of them.
constexpr double kReach = 1e3;

bool same_bits_or_nan(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_value(const model::Vector3& a, const model::Vector3& b) {
  return same_bits_or_nan(a.x, b.x) && same_bits_or_nan(a.y, b.y) && same_bits_or_nan(a.z, b.z);
}

bool same_value(const model::Quaternion& a, const model::Quaternion& b) {
  return same_bits_or_nan(a.w, b.w) && same_bits_or_nan(a.x, b.x) && same_bits_or_nan(a.y, b.y) &&
         same_bits_or_nan(a.z, b.z);
}

/// "meshes/a.stl" of "model://meshes/a.stl".
std::string_view uri_without_scheme(std::string_view uri) {
  const std::size_t scheme = uri.find("://");
  return scheme == std::string_view::npos ? uri : uri.substr(scheme + 3);
}

/// Whether a URI that nobody resolved names this file: `package://arm/a.stl` is `…/arm/a.stl`.
bool leads_to(std::string_view uri, std::string_view path) {
  const std::string_view tail = uri_without_scheme(uri);
  return tail.size() < uri.size() && path.size() > tail.size() && path.ends_with(tail) &&
         path[path.size() - tail.size() - 1] == '/';
}

}  // namespace

Apart apart(const model::Pose& a, const model::Pose& b) {
  Apart result;
  if (!same_value(a.translation, b.translation)) {
    result.distance = length(b.translation - a.translation);
  }
  if (!same_value(a.rotation, b.rotation)) {
    // From the vector part: an arc cosine of w loses half of the digits of a
    // small angle.
    const model::Quaternion turn = conjugate(a.rotation) * b.rotation;
    result.angle = 2 * std::atan2(model::length({turn.x, turn.y, turn.z}), std::abs(turn.w));
  }
  return result;
}

bool within(const Apart& apart, const Tolerance& tolerance, double reach) {
  const double scale = reach > kReach ? reach / kReach : 1;
  return apart.distance <= tolerance.distance * scale && apart.angle <= tolerance.angle;
}

bool near(const model::Pose& a, const model::Pose& b, const Tolerance& tolerance) {
  return within(apart(a, b), tolerance, length(a.translation));
}

bool near(const model::Vector3& a, const model::Vector3& b, const Tolerance& tolerance) {
  return near(model::Pose{a, {}}, model::Pose{b, {}}, tolerance);
}

bool near(double a, double b, const Tolerance& tolerance) {
  if (same_bits_or_nan(a, b)) return true;
  return std::abs(a - b) <= tolerance.relative * std::max(std::abs(a), std::abs(b)) &&
         std::isfinite(a) && std::isfinite(b);
}

bool near(const mass::Inertia& a, const mass::Inertia& b, const Tolerance& tolerance) {
  if (a == b) return true;
  const auto size = [](const mass::Inertia& i) {
    return std::max({std::abs(i.ixx), std::abs(i.ixy), std::abs(i.ixz), std::abs(i.iyy),
                     std::abs(i.iyz), std::abs(i.izz)});
  };
  const double allowed = tolerance.relative * std::max(size(a), size(b));
  const auto close = [allowed](double x, double y) {
    return same_bits_or_nan(x, y) || std::abs(x - y) <= allowed;
  };
  return close(a.ixx, b.ixx) && close(a.ixy, b.ixy) && close(a.ixz, b.ixz) && close(a.iyy, b.iyy) &&
         close(a.iyz, b.iyz) && close(a.izz, b.izz);
}

bool same_file(const Shape& a, const Shape& b) {
  if (a.submesh != b.submesh) return false;
  if (a.uri == b.uri) return true;  // beside its model, wherever that was copied to
  if (!a.path.empty() && !b.path.empty()) return normalize_path(a.path) == normalize_path(b.path);
  return uri_without_scheme(a.uri) == uri_without_scheme(b.uri) || leads_to(b.uri, a.path) ||
         leads_to(a.uri, b.path);
}

bool near(const Shape& a, const Shape& b, const Tolerance& tolerance) {
  return a.kind == b.kind && same_file(a, b) &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), b.numbers.end(),
                    [&](double x, double y) { return near(x, y, tolerance); });
}

}  // namespace rigor::robot
