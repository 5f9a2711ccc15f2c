// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/convex.h>
#include <rigor/rules/geometry/shape_key.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::visual_collision_origin {

using model::Vector3;

// Less is a gap that somebody wanted between a wheel and the ground, or a rounded number.
constexpr double kShare = 0.1;    // of the shape's longest side
constexpr double kOfMesh = 0.01;  // m, as its size may not be known
constexpr double kTurned = 0.1;   // rad

/// The collisions and the visuals of a shape, of which one each is to be compared.
struct Pair {
  std::vector<model::Id<model::Collision>> collisions;
  std::vector<model::Id<model::Visual>> visuals;
};

double angle_between(const model::Quaternion& a, const model::Quaternion& b) {
  const double cosine = std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z);
  return 2 * std::acos(std::min(1.0, cosine));
}

double largest_side(const Vector3& v) { return std::max({v.x, v.y, v.z}); }

/// Whether the two fill different places, whatever numbers say so: half a turn of a box is none.
bool differs(const model::Shape& shape, const model::Pose& X_WC, const model::Pose& X_WV) {
  const Vector3 moved = X_WC.translation - X_WV.translation;
  const auto collision = mass::ConvexShape::of(shape, X_WC);
  const auto visual = mass::ConvexShape::of(shape, X_WV);
  if (!collision || !visual) {
    if (!std::holds_alternative<model::Mesh>(shape)) return false;
    return model::length(moved) > kOfMesh || angle_between(X_WC.rotation, X_WV.rotation) > kTurned;
  }
  const mesh::Bounds a = collision->bounds(), b = visual->bounds();
  const double allowed = kShare * largest_side(a.max - a.min);
  return model::length(a.min - b.min) > allowed || model::length(a.max - b.max) > allowed;
}

// Of one shape in a link; each is compared with all others.
constexpr std::size_t kMaxAlike = 30;

/// Takes out each collision with a visual that is where it is, so that those are left which have none.
void leave_odd_ones(Pair& pair, const Context& context) {
  const model::Root& root = context.root();
  std::vector<model::Id<model::Collision>> left;
  for (const auto id : pair.collisions) {
    const auto X_WC = context.frames().pose(id);
    const auto here =
        std::find_if(pair.visuals.begin(), pair.visuals.end(), [&](const auto visual) {
          const auto X_WV = context.frames().pose(visual);
          return X_WC && X_WV && !differs(root[id].geometry.shape, *X_WC, *X_WV);
        });
    if (here == pair.visuals.end()) {
      left.push_back(id);
    } else {
      pair.visuals.erase(here);
    }
  }
  pair.collisions = std::move(left);
}

void check(const model::Link& link, Context& context) {
  if (link.collisions.empty() || link.visuals.empty()) return;
  const model::Root& root = context.root();
  std::map<ShapeKey, Pair> pairs;
  for (const auto id : link.collisions) {
    if (auto key = shape_key(root[id].geometry.shape))
      pairs[*std::move(key)].collisions.push_back(id);
  }
  for (const auto id : link.visuals) {
    const auto key = shape_key(root[id].geometry.shape);
    const auto pair = key ? pairs.find(*key) : pairs.end();
    if (pair != pairs.end()) pair->second.visuals.push_back(id);
  }
  for (auto& [key, pair] : pairs) {
    if (pair.collisions.size() != pair.visuals.size() || pair.visuals.size() > kMaxAlike) continue;
    if (pair.visuals.size() > 1) leave_odd_ones(pair, context);
    if (pair.collisions.size() != 1 || pair.visuals.size() != 1) continue;
    const model::Collision& collision = root[pair.collisions.front()];
    const model::Visual& visual = root[pair.visuals.front()];
    const auto X_WC = context.frames().pose(pair.collisions.front());
    const auto X_WV = context.frames().pose(pair.visuals.front());
    if (!X_WC || !X_WV || !differs(collision.geometry.shape, *X_WC, *X_WV)) continue;
    const Vector3 moved = X_WC->translation - X_WV->translation;
    context.report(
        {.where =
             collision.pose.site.name.nowhere() ? collision.site.name : collision.pose.site.name,
         .message = fmt::format(
             "the collision and the visual have the same {}, {:.3g} m and {:.3g}° "
             "apart",
             model::shape_name(collision.geometry.shape), model::length(moved),
             angle_between(X_WC->rotation, X_WV->rotation) * 180 / 3.14159265358979323846),
         .subject = context.subject(link),
         .related = {{visual.pose.site.name.nowhere() ? visual.site.name : visual.pose.site.name,
                      "the visual"}}});
  }
}

Rule rule() {
  return {
      .name = "visual-collision-origin",
      .severity = Severity::kWarning,
      .summary = "a link's collision and visual are the same shape in different places",
      .why = "The robot touches things beside what is drawn. Where one shape is written twice, "
             "mostly one of the two origins was forgotten, or has a slip: a sign, a decimal point, "
             "a rotation.",
      .what_to_do = "Give both the same origin.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::visual_collision_origin
