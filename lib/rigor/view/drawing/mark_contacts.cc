// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a model's collisions touch the ground or each other.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/mass/convex.h>
#include <rigor/robot/link_overlaps.h>
#include <rigor/view/drawing/mark_painter.h>

namespace rigor::view {
namespace {

using model::Id;
using model::Vector3;

/// Of the diagonal of a model.
constexpr double kContactRadius = 0.012;
/// m. A robot that stands on the ground is this much off it by the rounding of its file.
constexpr double kTouches = 1e-3;
/// m. So much above the lowest point one is as low.
constexpr double kAsLow = 1e-4;
/// A shape that lies flat touches with many points; those farthest in so many directions are marked.
constexpr std::array<std::array<double, 2>, 8> kOutward{
    {{2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}}};

double lowest_of(const std::vector<Vector3>& points) {
  double lowest = HUGE_VAL;
  for (const Vector3& p : points) lowest = std::min(lowest, p.z);
  return lowest;
}

/// The outermost of the lowest of them, each once; none when those are above the ground.
std::vector<Vector3> points_on_ground(const std::vector<Vector3>& points, double ground) {
  const double touches = ground + kTouches;
  const double lowest = std::min(touches, lowest_of(points));
  std::array<const Vector3*, kOutward.size()> outermost{};
  for (const Vector3& p : points) {
    if (!(p.z <= std::min(lowest + kAsLow, touches))) continue;
    for (std::size_t i = 0; i < kOutward.size(); ++i) {
      const auto reach = [&](const Vector3& q) {
        return kOutward[i][0] * q.x + kOutward[i][1] * q.y;
      };
      if (!outermost[i] || reach(p) > reach(*outermost[i])) outermost[i] = &p;
    }
  }
  std::vector<Vector3> result;
  for (const Vector3* p : outermost) {
    if (p && std::find(result.begin(), result.end(), *p) == result.end()) result.push_back(*p);
  }
  return result;
}

Vector3 middle_of_common_box(const mesh::Bounds& a, const mesh::Bounds& b) {
  const auto middle = [](double a_min, double b_min, double a_max, double b_max) {
    return (std::max(a_min, b_min) + std::min(a_max, b_max)) / 2;
  };
  return {middle(a.min.x, b.min.x, a.max.x, b.max.x), middle(a.min.y, b.min.y, a.max.y, b.max.y),
          middle(a.min.z, b.min.z, a.max.z, b.max.z)};
}

}  // namespace

void MarkPainter::draw_contacts() {
  const Mark mark = contact_mark();
  note_places();
  std::map<std::uint32_t, std::vector<Vector3>> points;
  // A model alone is set down on its lowest point.
  double ground = 0;
  for (std::uint32_t i = 0; i < root_.collisions.size(); ++i) {
    points[i] = points_of(Id<model::Collision>{i});
    if (root_.worlds.empty()) ground = std::min(ground, lowest_of(points[i]));
  }
  for (const auto& [i, places] : points) {
    for (const Vector3& p : points_on_ground(places, ground)) {
      const model::Collision& collision = root_.collisions[i];
      Body body{.layer = Layer::kContacts, .link = collision.link, .where = collision.site.tag};
      body.name = name_of(root_, collision.link) + "/contact with the ground";
      body.pose.translation = p;
      add_mark(std::move(body), mark, kContactRadius);
    }
  }
  touch_each_other(mark);
}

/// Of what may come to lie on the ground; none of what is static.
std::vector<Vector3> MarkPainter::points_of(Id<model::Collision> id) {
  const model::Collision& collision = root_[id];
  const auto X_WC = frames_.pose(id);
  if (!X_WC || !collision.link || model::is_static(root_, root_[collision.link].model)) return {};
  const FoundShape found = finder_.find(collision.geometry);
  if (!found.mesh || found.plane || !canvas_.may_look_at(found.mesh->positions.size())) return {};
  const model::Pose X_WS = compose(*X_WC, found.offset);
  const Vector3& s = found.scale;
  std::vector<Vector3> points;
  for (const Vector3& p : found.mesh->positions) {
    points.push_back(transform(X_WS, {s.x * p.x, s.y * p.y, s.z * p.z}));
  }
  return points;
}

void MarkPainter::touch_each_other(const Mark& mark) {
  const auto bounds = [this](const model::Collision* collision) {
    const auto id = static_cast<std::uint32_t>(collision - root_.collisions.data());
    const auto X_WC = frames_.pose(Id<model::Collision>{id});
    const auto shape =
        X_WC ? mass::ConvexShape::of(collision->geometry.shape, *X_WC) : std::nullopt;
    return shape ? std::optional(shape->bounds()) : std::nullopt;
  };
  for (const auto& [top, pairs] : robot::overlapping_links(root_, frames_)) {
    for (const robot::LinkOverlap& pair : pairs) {
      const auto a = bounds(pair.a);
      const auto b = bounds(pair.b);
      if (!a || !b) continue;
      Body body{.layer = Layer::kContacts, .link = pair.a->link, .where = pair.a->site.tag};
      body.name = name_of(root_, pair.a->link) + "/contact with " + name_of(root_, pair.b->link);
      body.pose.translation = middle_of_common_box(*a, *b);
      add_mark(std::move(body), mark, kContactRadius);
    }
  }
}

}  // namespace rigor::view
