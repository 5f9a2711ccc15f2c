// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene/mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/topology/edge_balance.h>

namespace rigor::simulate {
namespace {

/// The triangles of the part that is named, with corners that there are.
std::vector<mesh::Triangle> part_triangles(const mesh::TriangleMesh& mesh,
                                           const model::Mesh& shape) {
  std::vector<mesh::Triangle> kept;
  const std::string& name = shape.submesh.value;
  const auto add = [&](std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count && i < mesh.triangles.size(); ++i) {
      const mesh::Triangle& t = mesh.triangles[i];
      if (std::max({t[0], t[1], t[2]}) < mesh.positions.size()) kept.push_back(t);
    }
  };
  if (name.empty()) add(0, mesh.triangles.size());
  for (const mesh::Part& part : mesh.parts) {
    if (!name.empty() && part.name == name) add(part.first, part.count);
  }
  return kept;
}

/// ODE finds contacts with triangles that have no area, and with what is no number.
void drop_flat_triangles(mesh::TriangleMesh& mesh) {
  std::vector<mesh::Triangle> kept;
  for (const mesh::Triangle& t : mesh.triangles) {
    const double twice = model::length(mesh::area_vector(mesh::facet(mesh, t)));
    if (std::isfinite(twice) && twice > 0) kept.push_back(t);
  }
  if (kept.size() < mesh.triangles.size()) mesh = mesh::compacted(mesh.positions, std::move(kept));
}

void center_and_scale(mesh::TriangleMesh& mesh, const model::Mesh& shape) {
  if (shape.center.value && !shape.submesh.value.empty()) {
    const mesh::Bounds bounds = mesh::bounds_of(mesh.positions);
    const Vector3 middle = 0.5 * (bounds.min + bounds.max);
    for (Vector3& p : mesh.positions) p = p - middle;
  }
  const Vector3& s = shape.scale.value;
  for (Vector3& p : mesh.positions) p = {s.x * p.x, s.y * p.y, s.z * p.z};
  if (s.x * s.y * s.z < 0) {  // mirrored: the outside stays outside
    for (mesh::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
}

/// Before flat triangles go: one may close a gap.
void judge_hull(MeshShape& shape) {
  const mesh::TriangleMesh& mesh = shape.mesh;
  if (mesh.triangles.size() > kMaxFittedTriangles) return;
  shape.hull = mesh::convex_hull(mesh.positions);
  if (!shape.hull) return;
  mesh::EdgeBalance balance;
  for (const mesh::Triangle& t : mesh.triangles) balance.add(mesh::facet(mesh, t));
  if (!balance.closed()) return;
  shape.hull_share = mesh::enclosed_volume(mesh) / mesh::enclosed_volume(*shape.hull);
}

}  // namespace

const mesh::Fit* fit_of(MeshShape& shape) {
  if (!shape.hull) return nullptr;
  if (!shape.fit) shape.fit = mesh::fit_primitive(*shape.hull, mesh::FitKind::kBest);
  return shape.fit ? &*shape.fit : nullptr;
}

bool is_nearly(const mesh::Fit& fit) {
  const bool ball = std::holds_alternative<mesh::Sphere>(fit.shape);
  return fit.fill() >= (ball ? kNearlySphere : kNearlyPrimitive);
}

MeshShape* MeshShapes::find(const model::Mesh& mesh) {
  const mesh::LoadedMesh* loaded = load_ ? load_(mesh) : nullptr;
  if (loaded == nullptr || !loaded->usable()) return nullptr;
  const Vector3& s = mesh.scale.value;
  auto& known = known_[{loaded, mesh.submesh.value, mesh.center.value, {s.x, s.y, s.z}}];
  if (!known) {
    known = std::make_unique<MeshShape>();
    known->mesh = mesh::compacted(loaded->mesh.positions, part_triangles(loaded->mesh, mesh));
    center_and_scale(known->mesh, mesh);
    judge_hull(*known);
    drop_flat_triangles(known->mesh);
  }
  return known->mesh.triangles.empty() ? nullptr : known.get();
}

}  // namespace rigor::simulate
