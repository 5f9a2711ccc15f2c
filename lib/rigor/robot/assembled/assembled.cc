// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/assembled.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <variant>

#include <rigor/robot/placed_collisions.h>

namespace rigor::robot {
namespace {

using model::Vector3;

struct BoundsOfShape {
  ShapeRole role;
  const FindBounds& find_bounds;

  static std::optional<mesh::Bounds> around(const Vector3& half) {
    const double sum = half.x + half.y + half.z;
    if (!std::isfinite(sum) || !(std::min({half.x, half.y, half.z}) > 0)) return std::nullopt;
    return mesh::Bounds{-1 * half, half};
  }

  std::optional<mesh::Bounds> operator()(const model::Box& box) const {
    return around(0.5 * box.size.value);
  }
  std::optional<mesh::Bounds> operator()(const model::Sphere& ball) const {
    return around({ball.radius.value, ball.radius.value, ball.radius.value});
  }
  std::optional<mesh::Bounds> operator()(const model::Cylinder& shape) const {
    return around({shape.radius.value, shape.radius.value, shape.length.value / 2});
  }
  std::optional<mesh::Bounds> operator()(const model::Cone& shape) const {
    return around({shape.radius.value, shape.radius.value, shape.length.value / 2});
  }
  std::optional<mesh::Bounds> operator()(const model::Capsule& shape) const {
    const double r = shape.radius.value;
    return around({r, r, r + shape.length.value / 2});
  }
  std::optional<mesh::Bounds> operator()(const model::Ellipsoid& shape) const {
    return around(shape.radii.value);
  }
  std::optional<mesh::Bounds> operator()(const model::Polyline& outline) const {
    std::vector<Vector3> corners;
    for (const auto& point : outline.points) {
      corners.push_back(point.value);
      corners.push_back({point.value.x, point.value.y, outline.height.value});
    }
    if (corners.empty()) return std::nullopt;
    return mesh::bounds_of(corners);
  }
  std::optional<mesh::Bounds> operator()(const model::Mesh& mesh) const {
    if (!find_bounds) return std::nullopt;
    const auto found = find_bounds(mesh, role);
    if (!found) return std::nullopt;
    const Vector3& s = mesh.scale.value;
    const Vector3 a{s.x * found->min.x, s.y * found->min.y, s.z * found->min.z};
    const Vector3 b{s.x * found->max.x, s.y * found->max.y, s.z * found->max.z};
    if (!std::isfinite(model::length(a) + model::length(b))) return std::nullopt;
    return mesh::bounds_of({a, b});
  }
  template <class Other>
  std::optional<mesh::Bounds> operator()(const Other&) const {
    return std::nullopt;
  }
};

/// Of the ball inside of a box, m.
double inradius(const OrientedBox& box) {
  return std::min({box.half[0], box.half[1], box.half[2]});
}

/// What is seen or touched: a shape that some consumer takes.
bool counts(const model::Geometry& geometry) {
  const model::Shape& shape = geometry.shape;
  return !std::holds_alternative<model::NoShape>(shape) &&
         !std::holds_alternative<model::Plane>(shape) &&
         !std::holds_alternative<model::Heightmap>(shape);
}

/// Left and right of one list, model by model: those of the file itself.
template <class Entity, class MembersOf>
std::vector<Twins> twins_across(const std::vector<Entity>& all, const MembersOf& members_of,
                                const model::Root& root) {
  std::vector<Twins> result;
  std::vector<std::string_view> names;
  std::vector<std::uint32_t> own;
  for (const model::Model& model : root.models) {
    if (members_of(model).size() < 2) continue;
    names.clear();
    own.clear();
    for (const auto id : members_of(model)) {
      if (!root.own(all[id.value].site)) continue;
      names.push_back(all[id.value].name.value);
      own.push_back(id.value);
    }
    for (const Twins& pair : twins(names, Side::kAcross))
      result.push_back({own[pair.a], own[pair.b]});
  }
  return result;
}

class Assembler {
 public:
  Assembler(const model::Root& root, const model::Frames& frames, const FindBounds& find_bounds)
      : root_(root), frames_(frames), find_bounds_(find_bounds) {}

  Assembled run() {
    const auto top = top_models(root_);
    result_.links.resize(root_.links.size());
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      AssembledLink& link = result_.links[i];
      link.top = top[root_.links[i].model.value];
      link.X_WL = frames_.pose(model::Id<model::Link>{i});
      if (!link.X_WL) continue;
      for (const auto id : root_.links[i].collisions) add(i, ShapeRole::kCollision, id);
      for (const auto id : root_.links[i].visuals) add(i, ShapeRole::kVisual, id);
      result_.unknown += link.unknown;
    }
    for (std::uint32_t j = 0; j < root_.joints.size(); ++j) {
      const auto& ends = frames_.ends({j});
      if (!ends.child) continue;
      AssembledLink& child = result_.links[ends.child.value];
      if (!child.carrier) child.carrier = {j};
      if (ends.parent) result_.links[ends.parent.value].links_carried.push_back(ends.child.value);
    }
    result_.link_twins = twins_across(
        root_.links, [](const model::Model& model) -> const auto& { return model.links; }, root_);
    result_.joint_twins = twins_across(
        root_.joints, [](const model::Model& model) -> const auto& { return model.joints; }, root_);
    return std::move(result_);
  }

 private:
  template <class Id>
  void add(std::uint32_t link, ShapeRole role, Id id) {
    const model::Geometry& geometry = root_[id].geometry;
    if (!counts(geometry)) return;
    AssembledLink& to = result_.links[link];
    const auto X_WS = frames_.pose(id);
    const auto bounds_S = X_WS ? shape_bounds(geometry.shape, role, find_bounds_) : std::nullopt;
    if (!bounds_S) {
      ++to.unknown;
      return;
    }
    to.shapes.push_back(static_cast<std::uint32_t>(result_.shapes.size()));
    const model::Pose X_LS = model::compose(model::inverse(*to.X_WL), *X_WS);
    result_.shapes.push_back({role, id.value, link, *bounds_S, X_LS,
                              robot::bounds_of(box_around(*bounds_S, X_LS)),
                              box_around(*bounds_S, *X_WS), mesh::diagonal(*bounds_S) / 2});
  }

  const model::Root& root_;
  const model::Frames& frames_;
  const FindBounds& find_bounds_;
  Assembled result_;
};

}  // namespace

std::optional<mesh::Bounds> shape_bounds(const model::Shape& shape, ShapeRole role,
                                         const FindBounds& find_bounds) {
  return std::visit(BoundsOfShape{role, find_bounds}, shape);
}

Assembled assemble(const model::Root& root, const model::Frames& frames,
                   const FindBounds& find_bounds) {
  return Assembler(root, frames, find_bounds).run();
}

Links Assembled::subtree(std::uint32_t link) const {
  Links found{link};
  std::vector<bool> in(links.size(), false);
  in[link] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const std::uint32_t next : links[found[i]].links_carried) {
      if (in[next]) continue;
      in[next] = true;
      found.push_back(next);
    }
  }
  return found;
}

std::optional<mesh::Bounds> Assembled::bounds(std::uint32_t link, ShapeRole role) const {
  std::optional<mesh::Bounds> all;
  for (const std::uint32_t s : links[link].shapes) {
    if (shapes[s].role != role) continue;
    all = all ? joined(*all, shapes[s].bounds_L) : shapes[s].bounds_L;
  }
  return all;
}

std::optional<mesh::Bounds> Assembled::bounds_W(const Links& of) const {
  std::optional<mesh::Bounds> all;
  for (const std::uint32_t link : of) {
    for (const std::uint32_t s : links[link].shapes) {
      const mesh::Bounds one = robot::bounds_of(shapes[s].box_W);
      all = all ? joined(*all, one) : one;
    }
  }
  return all;
}

double Assembled::longest(const Links& of) const {
  double most = 0;
  for (const std::uint32_t link : of) {
    const auto all = bounds_W({link});
    if (all) most = std::max(most, mesh::diagonal(*all));
  }
  return most;
}

std::optional<double> Assembled::gap(const Links& of, const Vector3& d_W, double enough) const {
  std::vector<bool> in(links.size(), false);
  for (const std::uint32_t link : of) in[link] = true;
  double least = std::numeric_limits<double>::infinity();
  // Those that a joint holds together are the nearest as a rule; then few others have to be examined.
  const auto join = [&](std::uint32_t inside, std::uint32_t outside) {
    if (links[outside].top != links[inside].top) return;
    for (const std::uint32_t s : links[inside].shapes) {
      const OrientedBox box = moved(shapes[s].box_W, d_W);
      for (const std::uint32_t other : links[outside].shapes) {
        const OrientedBox& beside = shapes[other].box_W;
        if (least <= enough) return;
        // Most are near by the balls inside of them.
        const double balls =
            model::length(beside.center_W - box.center_W) - inradius(box) - inradius(beside);
        least = std::min(
            least, balls <= enough ? std::max(0.0, balls) : std::max(0.0, separation(box, beside)));
      }
    }
  };
  for (std::uint32_t link = 0; link < links.size(); ++link) {
    for (const std::uint32_t carried : links[link].links_carried) {
      if (in[link] != in[carried]) join(in[link] ? link : carried, in[link] ? carried : link);
    }
  }
  if (least <= enough) return least;
  for (const std::uint32_t link : of) {
    for (const std::uint32_t s : links[link].shapes) {
      const OrientedBox box = moved(shapes[s].box_W, d_W);
      for (const AssembledShape& other : shapes) {
        if (in[other.link] || links[other.link].top != links[link].top) continue;
        const double apart = model::length(other.box_W.center_W - box.center_W);
        if (apart - shapes[s].radius - other.radius >= least) continue;
        least = std::min(least, std::max(0.0, separation(box, other.box_W)));
        if (least <= enough) return least;
      }
    }
  }
  if (!std::isfinite(least)) return std::nullopt;
  return least;
}

}  // namespace rigor::robot
