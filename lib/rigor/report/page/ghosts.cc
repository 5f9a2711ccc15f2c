// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/ghosts.h>

#include <cmath>

namespace rigor::report {
namespace {

using view::Body;
using view::Layer;

// Less is a number that was read and written again.
constexpr double kSame = 1e-9;

std::vector<std::size_t> parts_of(const view::Drawing& drawing) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < drawing.bodies.size(); ++i) {
    const Layer layer = drawing.bodies[i].layer;
    if (layer == Layer::kVisual || layer == Layer::kCollision) parts.push_back(i);
  }
  return parts;
}

bool same_pose(const model::Pose& a, const model::Pose& b) {
  const model::Quaternion &p = a.rotation, &q = b.rotation;
  const double cosine = std::abs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z);
  return model::length(a.translation - b.translation) <= kSame && cosine >= 1 - kSame;
}

/// Boxes share a mesh within one drawing, and files in all.
bool same_mesh(const Body& a, const Body& b) {
  return a.mesh == b.mesh || (a.mesh->positions.size() == b.mesh->positions.size() &&
                              a.mesh->triangles.size() == b.mesh->triangles.size());
}

}  // namespace

std::vector<PageGhost> ghosts_between(const view::Drawing& now, const view::Drawing& then,
                                      std::size_t finding) {
  const std::vector<std::size_t> old_parts = parts_of(now), new_parts = parts_of(then);
  if (old_parts.size() != new_parts.size()) return {};
  std::vector<PageGhost> ghosts;
  for (std::size_t i = 0; i < old_parts.size(); ++i) {
    const Body& a = now.bodies[old_parts[i]];
    const Body& b = then.bodies[new_parts[i]];
    if (a.name != b.name || a.layer != b.layer) return {};
    if (same_pose(a.pose, b.pose) && model::length(a.scale - b.scale) <= kSame) continue;
    if (same_mesh(a, b)) ghosts.push_back({finding, old_parts[i], b.pose, b.scale});
  }
  return ghosts;
}

}  // namespace rigor::report
