// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/symmetry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor::robot {
namespace {

using model::Vector3;

constexpr std::array<double Vector3::*, 3> kAxes{&Vector3::x, &Vector3::y, &Vector3::z};

// Calibrated robots differ by tenths of a millimeter, and files are rounded.
constexpr double kMirrorImage = 1e-3;  // m

/// The plane halfway between two points, when it is normal to an axis.
std::optional<MirrorPlane> halfway(const Vector3& p, const Vector3& q) {
  const Vector3 d = p - q;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = std::abs(d.*kAxes[k]);
    const double across = std::hypot(d.*kAxes[(k + 1) % 3], d.*kAxes[(k + 2) % 3]);
    if (along > 2 * kMirrorImage && across <= kMirrorImage)
      return MirrorPlane{k, (p.*kAxes[k] + q.*kAxes[k]) / 2, 0, 0};
  }
  return std::nullopt;
}

}  // namespace

Vector3 mirrored(const MirrorPlane& plane, Vector3 p_W) {
  p_W.*kAxes[plane.axis] = 2 * plane.at - p_W.*kAxes[plane.axis];
  return p_W;
}

bool are_mirrored(const MirrorPlane& plane, const Vector3& p_W, const Vector3& q_W) {
  return model::length(mirrored(plane, p_W) - q_W) <= kMirrorImage;
}

std::optional<MirrorPlane> symmetry_plane(const Assembled& robot, const std::vector<Twins>& pairs) {
  std::optional<MirrorPlane> best;
  for (const Twins& pair : pairs) {
    const auto& X_WA = robot.links[pair.a].X_WL;
    const auto& X_WB = robot.links[pair.b].X_WL;
    auto plane = X_WA && X_WB ? halfway(X_WA->translation, X_WB->translation) : std::nullopt;
    if (!plane) continue;
    if (best && best->axis == plane->axis && std::abs(best->at - plane->at) < kMirrorImage)
      continue;
    for (const Twins& other : pairs) {
      const auto& X_WC = robot.links[other.a].X_WL;
      const auto& X_WD = robot.links[other.b].X_WL;
      const bool fits = X_WC && X_WD && are_mirrored(*plane, X_WC->translation, X_WD->translation);
      ++(fits ? plane->pairs : plane->others);
    }
    if (!best || plane->pairs > best->pairs) best = plane;
  }
  constexpr std::size_t kFewest = 2;
  if (!best || best->pairs < kFewest || best->pairs <= best->others) return std::nullopt;
  return best;
}

}  // namespace rigor::robot
