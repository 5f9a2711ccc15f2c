// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/primitive/fit.h>

#include <array>
#include <functional>
#include <vector>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/primitive/fit_axis.h>
#include <rigor/mesh/primitive/fit_ball.h>
#include <rigor/mesh/primitive/fit_depth.h>
#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/edge_balance.h>

namespace rigor::mesh {
namespace {

/// A volume less by no more than this share is the same: rounding must not choose between axes.
constexpr double kSameVolume = 1e-9;

/// The first tilt reaches halfway to the next of some ten axes in a quarter circle; the last one moves
/// no vertex by more than a ten-millionth of the size.
constexpr double kFirstTilt = 0.1;
constexpr double kLastTilt = 1e-7;
constexpr int kMaxTilts = 200;

using Along = std::function<Placed(const Vector3& axis)>;

bool keep_lesser(Placed& best, const Placed& other) {
  if (other.volume >= best.volume * (1 - kSameVolume)) return false;
  best = other;
  return true;
}

/// Tilts the axis four ways, and less when none is better (pattern search: R. Hooke, T. A. Jeeves,
/// 1961).
Placed tilted(Placed best, Vector3 axis, const Along& along) {
  double step = kFirstTilt;
  for (int i = 0; i < kMaxTilts && step > kLastTilt; ++i) {
    const Basis basis = basis_about(axis);
    bool better = false;
    for (const Vector3& side : {basis[0], -1.0 * basis[0], basis[1], -1.0 * basis[1]}) {
      Vector3 other = basis[2] + step * side;
      other = (1 / length(other)) * other;
      if (!keep_lesser(best, along(other))) continue;
      axis = other;
      better = true;
      break;
    }
    if (!better) step /= 2;
  }
  return best;
}

/// The smallest of those along the axes; `aligned` is the smallest along the coordinate axes.
Placed smallest_box(const Placed& aligned, const std::vector<Vector3>& axes, const Along& along) {
  Placed best = aligned;
  Vector3 best_axis = axes.front();
  for (const Vector3& axis : axes) {
    if (keep_lesser(best, along(axis))) best_axis = axis;
  }
  best = tilted(best, best_axis, along);
  return aligned.volume <= best.volume * (1 + kAlignedVolume) ? aligned : best;
}

Placed smallest_box(const std::vector<Vector3>& points, const std::vector<Vector3>& axes) {
  return smallest_box(box_along(basis_about({0, 0, 1}), points), axes,
                      [&points](const Vector3& axis) { return box_about(axis, points); });
}

Placed smallest_ball(const std::vector<Vector3>& points) {
  const Ball ball = enclosing_ball(points);
  const Sphere sphere{ball.radius};
  return {sphere, {ball.center, {}}, volume_of(sphere)};
}

Placed smallest_round(const std::vector<Vector3>& axes, const Along& along) {
  Placed aligned = along(axes[0]);
  for (std::size_t i = 1; i < kCoordinateAxes; ++i) keep_lesser(aligned, along(axes[i]));
  return smallest_box(aligned, axes, along);
}

Placed place(FitKind kind, const std::vector<Vector3>& points, const std::vector<Vector3>& axes) {
  switch (kind) {
    case FitKind::kSphere: return smallest_ball(points);
    case FitKind::kBox: return smallest_box(points, axes);
    case FitKind::kCylinder:
      return smallest_round(
          axes, [&points](const Vector3& axis) { return cylinder_along(axis, points); });
    case FitKind::kCapsule:
      return smallest_round(axes,
                            [&points](const Vector3& axis) { return capsule_along(axis, points); });
    case FitKind::kBest: break;
  }
  Placed best = place(FitKind::kSphere, points, axes);
  for (const FitKind next : {FitKind::kBox, FitKind::kCylinder, FitKind::kCapsule}) {
    const Placed other = place(next, points, axes);
    if (other.volume < best.volume * (1 - kSimplerVolume)) best = other;
  }
  return best;
}

std::optional<double> volume_if_closed(const TriangleMesh& mesh) {
  EdgeBalance balance;
  for (const Triangle& t : mesh.triangles) balance.add(facet(mesh, t));
  if (!balance.closed()) return std::nullopt;
  return enclosed_volume(mesh);
}

}  // namespace

std::optional<Fit> fit_primitive(const TriangleMesh& mesh, FitKind kind) {
  const std::vector<Vector3> points = used_positions(mesh);
  const auto hull = convex_hull(points);
  if (!hull) return std::nullopt;
  const Placed found = place(kind, hull->positions, axes_to_try(*hull));
  Fit fit{found.shape, found.pose, found.volume, enclosed_volume(*hull), volume_if_closed(mesh), 0};
  fit.deepest = deepest(mesh, fit.shape, fit.pose);
  return fit;
}

}  // namespace rigor::mesh
