// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the shapes of a link reach: what bounds where its mass can be. Unlike solids, open meshes
// have a reach as well.
//
//   Outline outline(link, context);
//   if (outline.add_collisions(link) && outline.reach({0, 0, 1}) < com.z) …

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/shapes.h>
#include <rigor/model/geometry.h>
#include <rigor/rules/context.h>
#include <rigor/rules/inertia/rigid_groups.h>

namespace rigor::rules {

/// How far a shape reaches along the unit vector `d` of its own frame, m.
struct ShapeReach {
  const model::Vector3& d;

  double across() const { return std::hypot(d.x, d.y); }
  double along() const { return std::abs(d.z); }

  double operator()(const model::Box& box) const {
    const model::Vector3& size = box.size.value;
    return (std::abs(d.x) * size.x + std::abs(d.y) * size.y + along() * size.z) / 2;
  }
  double operator()(const model::Sphere& ball) const { return ball.radius.value; }
  double operator()(const model::Capsule& capsule) const {
    return capsule.radius.value + along() * capsule.length.value / 2;
  }
  double operator()(const model::Ellipsoid& ellipsoid) const {
    const model::Vector3& radii = ellipsoid.radii.value;
    return std::hypot(d.x * radii.x, d.y * radii.y, d.z * radii.z);
  }
  double operator()(const model::Cylinder& shape) const { return round(shape); }
  double operator()(const model::Cone& shape) const { return round(shape); }
  template <class Other>
  double operator()(const Other&) const {
    return 0;
  }

  template <class Shape>
  double round(const Shape& shape) const {
    return across() * shape.radius.value + along() * shape.length.value / 2;
  }
};

/// The shapes of a link, and of others that count to it, in the frame of the link.
class Outline {
 public:
  Outline(const model::Link& link, Context& context)
      : context_(context),
        X_WL_(context.frames().pose(model::Id<model::Link>{
            static_cast<std::uint32_t>(&link - context.root().links.data())})) {}

  /// False when one of the shapes has no known reach or no place. Of any link.
  bool add_collisions(const model::Link& link) { return add(link.collisions); }
  bool add_visuals(const model::Link& link) { return add(link.visuals); }

  bool empty() const { return parts_.empty(); }

  /// How far the shapes reach from the link's origin along a unit vector, m.
  double reach(const model::Vector3& d_L) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Part& part : parts_) {
      const model::Vector3 d = model::rotate(model::conjugate(part.X_LS.rotation), d_L);
      most = std::max(
          most, model::dot(d_L, part.X_LS.translation) + std::visit(ShapeReach{d}, part.shape));
    }
    return most;
  }
  /// In any direction the shapes are at least so wide, m: as the box that is widest where it is thinnest.
  double least_width() const {
    double least = 0;
    for (const Part& part : parts_) {
      const auto reach = [&part](const model::Vector3& d) {
        return std::visit(ShapeReach{d}, part.shape);
      };
      least = std::max(least, 2 * std::min({reach({1, 0, 0}), reach({0, 1, 0}), reach({0, 0, 1})}));
    }
    return least;
  }
  /// m
  double extent(const model::Vector3& d_L) const { return reach(d_L) + reach(-1 * d_L); }

 private:
  struct Part {
    model::Pose X_LS;
    model::Shape shape;
  };

  template <class Id>
  bool add(const std::vector<Id>& ids) {
    if (!X_WL_) return false;
    for (const Id id : ids) {
      const auto X_WS = context_.frames().pose(id);
      if (!X_WS ||
          !add(context_.root()[id].geometry.shape, model::compose(model::inverse(*X_WL_), *X_WS))) {
        return false;
      }
    }
    return true;
  }

  bool add(const model::Shape& shape, const model::Pose& X_LS) {
    if (const auto* mesh = std::get_if<model::Mesh>(&shape)) return add(*mesh, X_LS);
    // Of an extruded outline, which is rare, nothing is said.
    if (std::holds_alternative<model::Polyline>(shape) || !mass::solid_of(shape)) return false;
    parts_.push_back({X_LS, shape});
    return true;
  }

  /// The box around it.
  bool add(const model::Mesh& mesh, const model::Pose& X_LS) {
    const mass::MeshSurvey* survey = context_.survey(mesh);
    if (survey == nullptr || !survey->usable() || survey->triangles == 0) return false;
    const model::Vector3& scale = mesh.scale.value;
    const auto scaled = [&scale](const auto& p) {
      return model::Vector3{scale.x * p.x, scale.y * p.y, scale.z * p.z};
    };
    const model::Vector3 a = scaled(survey->bounds.min), b = scaled(survey->bounds.max);
    const model::Vector3 size{std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(b.z - a.z)};
    if (!std::isfinite(size.x + size.y + size.z)) return false;
    parts_.push_back({model::compose(X_LS, {0.5 * (a + b), {}}), model::Box{{.value = size}}});
    return true;
  }

  Context& context_;
  std::optional<model::Pose> X_WL_;
  std::vector<Part> parts_;
};

/// The outline of all that can be the body of a link: its collisions, its visuals, and the shapes of links
/// that are fixed to it and have no mass of their own. Nothing when a part of it is unknown, or when
/// `breaks` is false for a part already: more shapes only allow more.
template <class Breaks>
std::optional<Outline> outline_that_breaks(const model::Link& link, LazyGroups& groups,
                                           Context& context, Breaks breaks) {
  Outline outline(link, context);
  if (!outline.add_collisions(link)) return std::nullopt;
  if (!outline.empty() && !breaks(outline)) return std::nullopt;
  if (!outline.add_visuals(link) || outline.empty() || !breaks(outline)) return std::nullopt;
  for (const model::Link* other : groups.massless_beside(link)) {
    if (!outline.add_collisions(*other) || !outline.add_visuals(*other)) return std::nullopt;
  }
  if (!breaks(outline)) return std::nullopt;
  return outline;
}

/// Checks the links of the file itself, which share the groups.
template <void (*check_link)(const model::Link&, LazyGroups&, Context&)>
void check_own_links(const model::Root& root, Context& context) {
  LazyGroups groups(context);
  for (const model::Link& link : root.links) {
    if (root.own(link.site)) check_link(link, groups, context);
  }
}

}  // namespace rigor::rules
