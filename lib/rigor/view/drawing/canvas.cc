// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/canvas.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor::view {
namespace {

using model::Vector3;

void widen(mesh::Bounds& bounds, const Vector3& p) {
  bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y),
                std::min(bounds.min.z, p.z)};
  bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y),
                std::max(bounds.max.z, p.z)};
}

bool is_near(const Vector3& p) {
  return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

/// Of all corners; nothing when one is no place, or too far away.
std::optional<mesh::Bounds> bounds_of_body(const Body& body) {
  const model::Matrix3 R = to_matrix(body.pose.rotation);
  const std::array<double, 3> scale{body.scale.x, body.scale.y, body.scale.z};
  model::Matrix3 m = R;
  for (auto& row : m) {
    for (std::size_t i = 0; i < 3; ++i) row[i] *= scale[i];
  }
  const auto place = [&](const Vector3& p) {
    return Vector3{m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + body.pose.translation.x,
                   m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + body.pose.translation.y,
                   m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + body.pose.translation.z};
  };
  mesh::Bounds bounds = mesh::bounds_of({});
  for (const mesh::Triangle& t : body.mesh->triangles) {
    for (const std::uint32_t corner : t) {
      if (corner >= body.mesh->positions.size()) return std::nullopt;
      const Vector3 p = place(body.mesh->positions[corner]);
      if (!is_near(p)) return std::nullopt;
      widen(bounds, p);
    }
  }
  return bounds;
}

}  // namespace

void Canvas::refuse(const Body& body, std::string why) {
  drawing_.not_drawn.push_back({body.name, std::move(why), body.where});
}

bool Canvas::may_look_at(std::size_t places) {
  if (places > kMaxPlacedTriangles - places_) return false;
  places_ += places;
  return true;
}

bool Canvas::has_room(const Body& body) {
  if (drawing_.bodies.size() >= kMaxBodies) {
    refuse(body, "more than " + std::to_string(kMaxBodies) + " bodies are not drawn");
    return false;
  }
  const std::size_t count = body.mesh->triangles.size();
  const bool is_new = !meshes_.contains(body.mesh.get());
  if (is_new && count > kMaxDrawnTriangles - triangles_) {
    refuse(body, "more than " + std::to_string(kMaxDrawnTriangles) + " triangles are not drawn");
    return false;
  }
  if (!may_look_at(count)) {
    refuse(body, "more than " + std::to_string(kMaxPlacedTriangles) +
                     " triangles, each time they are seen, are not drawn");
    return false;
  }
  if (is_new) triangles_ += count;
  meshes_.insert(body.mesh.get());
  return true;
}

void Canvas::add(Body body) {
  if (!has_room(body)) return;
  const auto bounds = bounds_of_body(body);
  if (!bounds) {
    refuse(body, "it lies where nothing is drawn: a place is no number, or too far away");
    return;
  }
  if (!body.mesh->triangles.empty()) {
    const bool shape = body.layer == Layer::kVisual || body.layer == Layer::kCollision;
    if (shape) lowest_shape_ = std::min(lowest_shape_, bounds->min.z);
    for (const Vector3& corner : {bounds->min, bounds->max}) {
      widen(drawing_.bounds, corner);
      note(body.link, corner);
    }
  }
  drawing_.bodies.push_back(std::move(body));
}

bool Canvas::put_off(Body body) {
  const model::Quaternion& q = body.pose.rotation;
  if (!is_near(body.pose.translation) || !std::isfinite(q.w + q.x + q.y + q.z)) {
    refuse(body, "it lies where nothing is drawn: a place is no number, or too far away");
    return false;
  }
  if (!has_room(body)) return false;
  drawing_.bodies.push_back(std::move(body));
  return true;
}

void Canvas::bound_all() {
  for (const Body& body : drawing_.bodies) {
    const auto bounds = bounds_of_body(body);
    if (!bounds || body.mesh->triangles.empty()) continue;
    widen(drawing_.bounds, bounds->min);
    widen(drawing_.bounds, bounds->max);
  }
}

std::uint32_t Canvas::outermost(model::Id<model::Link> link) const {
  if (!link) return model::Id<model::Model>::kNone;
  model::Id<model::Model> at = root_[link].model;
  while (at && root_[at].parent) at = root_[at].parent;
  return at.value;
}

void Canvas::note(model::Id<model::Link> link, const Vector3& place) {
  if (!is_near(place)) return;
  widen(models_.try_emplace(outermost(link), mesh::bounds_of({})).first->second, place);
}

double Canvas::size_around(model::Id<model::Link> link) const {
  const auto found = models_.find(outermost(link));
  const double size = found == models_.end() ? 0 : mesh::diagonal(found->second);
  return size > 0 ? size : 1;
}

}  // namespace rigor::view
