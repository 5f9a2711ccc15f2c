// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collisions as shapes that an engine has. What is only nearly what the file says becomes a fact.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include <rigor/mass/polyline.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/convex/strict_hull.h>
#include <rigor/mesh/image/height_picture.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/select.h>
#include <rigor/simulate/scene/draft.h>
#include <rigor/simulate/scene/mesh.h>

namespace rigor::simulate {
namespace {

/// How far the axis of a joint may be from that of a mesh that it rolls on: as a share of the radius, and
/// in radians.
constexpr double kOnAxis = 0.05;
constexpr double kAlongAxis = 0.02;

/// Points of a circle, of which cones are the hull: within 0.12 % of the radius.
constexpr unsigned kConeSides = mesh::kCircleSegments;

std::vector<Vector3> cone_points(double radius, double height) {
  std::vector<Vector3> points{{0, 0, height / 2}};
  for (unsigned i = 0; i < kConeSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kConeSides;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), -height / 2});
  }
  return points;
}

std::vector<Vector3> ellipsoid_points(const Vector3& radii) {
  std::vector<Vector3> points = mesh::mesh_of(mesh::Sphere{1}).positions;
  for (Vector3& p : points) p = {radii.x * p.x, radii.y * p.y, radii.z * p.z};
  return points;
}

std::vector<Vector3> prism_points(const model::Polyline& polyline) {
  std::vector<Vector3> points;
  for (const auto& p : polyline.points) {
    points.push_back({p.value.x, p.value.y, 0});
    points.push_back({p.value.x, p.value.y, polyline.height.value});
  }
  return points;
}

std::string_view primitive_name(const mesh::Primitive& primitive) {
  constexpr std::array<std::string_view, 4> kNames{"box", "sphere", "cylinder", "capsule"};
  return kNames[primitive.index()];
}

class ShapeBuilder {
 public:
  explicit ShapeBuilder(SceneDraft& draft)
      : draft_(draft),
        scene_(draft.scene),
        meshes_(draft.input.load_mesh),
        counted_(draft.root.links.size()) {}

  void build() {
    const model::Root& root = draft_.root;
    for (std::uint32_t i = 0; i < root.collisions.size(); ++i) {
      const model::Id<model::Link> link = root.collisions[i].link;
      if (link && draft_.link_of[link.value] != kWorld) add({i});
    }
  }

 private:
  void add(model::Id<model::Collision> id) {
    collision_ = &draft_.root[id];
    shape_ = {};
    shape_.link = draft_.link_of[collision_->link.value];
    const SceneLink& link = scene_.links[shape_.link];
    shape_.body = link.body;
    shape_.name = callable_name(id, ++counted_[collision_->link.value]);
    shape_.where = collision_->geometry.site.name;
    if (shape_.where.nowhere()) shape_.where = collision_->site.name;
    if (collision_->pose.relative_to.value.empty()) {
      shape_.X_BS = link.X_BL == Pose{} ? collision_->pose.pose.value
                                        : compose(link.X_BL, collision_->pose.pose.value);
    } else if (const auto X_WS = draft_.input.frames.pose(id)) {
      const bool of_world = shape_.body == kWorld;
      shape_.X_BS = of_world ? *X_WS : compose(inverse(scene_.bodies[shape_.body].X_WB), *X_WS);
    } else {
      return say(FactKind::kUnreadable, collision_->pose.relative_to.span, "no pose");
    }
    const Quaternion R_BC =
        shape_.X_BS.rotation;  // a mesh may be replaced by a shape that is turned
    for (const model::Site& more : collision_->geometry.more) {
      say(FactKind::kShapeIgnored, more.name, "a second shape");
    }
    if (std::visit([this](const auto& shape) { return make(shape); }, collision_->geometry.shape)) {
      shape_.surface = surface_of(draft_, *collision_);
      // SDFormat: "in the collision's local reference frame".
      Vector3& fdir1 = shape_.surface.fdir1;
      fdir1 = rotate(conjugate(link.X_BL.rotation), rotate(R_BC, fdir1));
      scene_.shapes.push_back(shape_);
    }
  }

  /// URDF's collisions need no name: "#2" is the second one of its link.
  std::string callable_name(model::Id<model::Collision> id, std::size_t number) const {
    if (!collision_->name.value.empty()) return scoped_name(draft_.root, id);
    return scoped_name(draft_.root, collision_->link) + "::#" + std::to_string(number);
  }

  // Each says whether there is a shape.

  bool make(const model::NoShape&) {
    if (!collision_->geometry.explicitly_empty) {
      say(FactKind::kShapeIgnored, shape_.where, "no shape");
    }
    return false;
  }
  bool make(const model::Box& box) {
    const Vector3& s = box.size.value;
    return sized(box.size.span, "size", std::min({s.x, s.y, s.z})) && take(mesh::Box{s});
  }
  bool make(const model::Sphere& s) {
    return sized(s.radius.span, "radius", s.radius.value) && take(mesh::Sphere{s.radius.value});
  }
  bool make(const model::Cylinder& c) {
    return round(c) && take(mesh::Cylinder{c.radius.value, c.length.value});
  }
  bool make(const model::Capsule& c) {
    return round(c) && take(mesh::Capsule{c.radius.value, c.length.value});
  }
  bool make(const model::Cone& c) {
    return round(c) && hull_of(cone_points(c.radius.value, c.length.value), "cone");
  }
  bool make(const model::Ellipsoid& e) {
    const Vector3& r = e.radii.value;
    if (!sized(e.radii.span, "radii", std::min({r.x, r.y, r.z}))) return false;
    if (r.x == r.y && r.y == r.z) return take(mesh::Sphere{r.x});
    return hull_of(ellipsoid_points(r), "ellipsoid");
  }
  bool make(const model::Polyline& p) {
    if (!sized(p.height.span, "height", p.height.value)) return false;
    if (hull_of(prism_points(p), "polyline")) return true;
    say(FactKind::kShapeSize, shape_.where, "point");
    return false;
  }
  bool make(const model::Plane& plane) {
    const double size = length(plane.normal.value);
    if (!(size > 0)) {
      say(FactKind::kAxisZero, or_shape(plane.normal.span), "normal");
      return false;
    }
    if (shape_.body != kWorld) return left_out("a plane that moves");
    shape_.kind = HalfSpace{1 / size * plane.normal.value};
    shape_.extent = kInfinity;
    return true;
  }
  bool make(const model::Heightmap& map) {
    const Vector3& s = map.size.value;
    // A z of zero is flat ground.
    if (!sized(map.size.span, "size", std::min(s.x, s.y))) return false;
    if (s.z < 0) return sized(map.size.span, "size", s.z);
    if (shape_.body != kWorld) return left_out("a heightmap that moves");
    const LoadedHeights& loaded = draft_.input.load_heights(map);
    if (!loaded.picture) return left_out("the heightmap's image " + loaded.why);
    const mesh::HeightPicture& picture = *loaded.picture;
    if (picture.width != picture.height || !std::has_single_bit(picture.width - 1)) {
      return left_out("a heightmap of " + std::to_string(picture.width) + " by " +
                      std::to_string(picture.height) +
                      " pixels: Gazebo takes a square of 2^n + 1, as 129 by 129");
    }
    shape_.kind = grid_of(picture, s);
    shape_.extent = std::max(s.x, s.y);
    const auto offset = read::child_text(draft_.element(collision_->geometry.site), "pos");
    shape_.X_BS = compose(shape_.X_BS, {read::vector_field(offset, {}).value, {}});
    return true;
  }
  bool make(const model::Image&) { return left_out("image"); }
  bool make(const model::Mesh& mesh) {
    const Vector3& s = mesh.scale.value;
    if (s.x == 0 || s.y == 0 || s.z == 0) {
      say(FactKind::kShapeSize, or_shape(mesh.scale.span), "scale");
      return false;
    }
    MeshShape* found = meshes_.find(mesh);
    if (found == nullptr) {
      say(FactKind::kMeshMissing, or_shape(mesh.uri.span), mesh.uri.value);
      ++scene_.models[scene_.links[shape_.link].model].missing_shapes;
      return false;
    }
    return take_mesh(*found);
  }

  /// As Gazebo has it: the picture as seen from above, y upward on it; its brightest pixel is as high
  /// as `size.z`, black is zero. (Its `<sampling>` only puts more points between the pixels.)
  static HeightGrid grid_of(const mesh::HeightPicture& picture, const Vector3& size) {
    const double brightest = *std::max_element(picture.levels.begin(), picture.levels.end());
    const double scale = brightest > 0 ? size.z / brightest : 0;
    HeightGrid grid{picture.width, picture.height, size.x, size.y, {}};
    grid.heights.reserve(picture.levels.size());
    for (std::uint32_t row = picture.height; row-- > 0;) {
      for (std::uint32_t column = 0; column < picture.width; ++column) {
        grid.heights.push_back(scale * picture.at(column, row));
      }
    }
    return grid;
  }

  bool left_out(std::string why) {
    say(FactKind::kShapeIgnored, shape_.where, std::move(why));
    return false;
  }

  template <class Round>
  bool round(const Round& shape) {
    return sized(shape.radius.span, "radius", shape.radius.value) &&
           sized(shape.length.span, "length", shape.length.value);
  }

  bool sized(Span where, std::string name, double least) {
    if (least > 0) return true;
    say(FactKind::kShapeSize, or_shape(where), std::move(name), least);
    return false;
  }

  bool take(const mesh::Primitive& primitive) {
    std::visit([this](const auto& shape) { shape_.kind = shape; }, primitive);
    const mesh::Bounds bounds = mesh::bounds_of(mesh::mesh_of(primitive).positions);
    take_extent(bounds);
    return true;
  }

  void take_extent(const mesh::Bounds& bounds) {
    const Vector3 sides = bounds.max - bounds.min;
    shape_.extent = std::max({sides.x, sides.y, sides.z});
  }

  bool hull_of(const std::vector<Vector3>& points, std::string name) {
    const auto hull = add_hull(points);
    if (!hull) return false;
    shape_.kind = ConvexHull{*hull};
    take_extent(mesh::bounds_of(scene_.meshes[*hull].positions));
    say(FactKind::kShapeAsHull, shape_.where, std::move(name));
    return true;
  }

  std::optional<std::uint32_t> add_hull(const std::vector<Vector3>& points) {
    auto hull = mesh::convex_hull(points);
    if (!hull) return std::nullopt;
    scene_.meshes.push_back(mesh::made_strict(std::move(*hull)));
    return static_cast<std::uint32_t>(scene_.meshes.size() - 1);
  }

  bool take_mesh(MeshShape& found) {
    take_extent(mesh::bounds_of(found.mesh.positions));
    const MeshAs as = draft_.options.meshes;
    const bool automatic = as == MeshAs::kAuto;
    if (const mesh::Fit* fit = automatic ? primitive_for(found) : nullptr) {
      say(FactKind::kMeshAsPrimitive, shape_.where, std::string(primitive_name(fit->shape)),
          fit->fill());
      shape_.X_BS = compose(shape_.X_BS, fit->pose);
      return take(fit->shape);
    }
    const bool too_large = found.mesh.triangles.size() > kMaxTriangles;
    const bool convex = automatic && found.convex() && shape_.body != kWorld;
    if (as == MeshAs::kHull || too_large || convex) {
      if (found.hull_index == kWorld) {
        const auto& points = found.hull ? found.hull->positions : found.mesh.positions;
        found.hull_index = add_hull(points).value_or(kWorld);
      }
      if (found.hull_index != kWorld) {
        shape_.kind = ConvexHull{found.hull_index};
        const char* why = too_large ? "too large" : convex ? "convex" : "asked for";
        say(FactKind::kMeshAsHull, shape_.where, why);
        return true;
      }
    }
    if (found.index == kWorld) {
      found.index = static_cast<std::uint32_t>(scene_.meshes.size());
      scene_.meshes.push_back(found.mesh);
    }
    shape_.kind = TriangleSoup{found.index};
    return true;
  }

  /// The primitive that a mesh nearly is. A rim that is hollow is a wheel all the same, where it turns
  /// endlessly about its own axis: all that it touches with is its outside.
  const mesh::Fit* primitive_for(MeshShape& found) const {
    const bool full = found.hull_share >= kNearlyPrimitive;
    if (!full && !turns_endlessly()) return nullptr;
    const mesh::Fit* fit = fit_of(found);
    return fit != nullptr && is_nearly(*fit) && (full || rolls(*fit)) ? fit : nullptr;
  }

  bool is_endless(const SceneJoint& joint) const {
    return joint.child == shape_.body && joint.type == model::JointType::kRevolute &&
           std::isinf(joint.axes.front().lower) && std::isinf(joint.axes.front().upper);
  }
  bool turns_endlessly() const {
    return shape_.body != kWorld &&
           std::any_of(scene_.joints.begin(), scene_.joints.end(),
                       [this](const SceneJoint& joint) { return is_endless(joint); });
  }

  bool rolls(const mesh::Fit& fit) const {
    const auto* cylinder = std::get_if<mesh::Cylinder>(&fit.shape);
    if (cylinder == nullptr) return false;
    const Pose X_WS = compose(scene_.bodies[shape_.body].X_WB, shape_.X_BS);
    const Pose X_WP = compose(X_WS, fit.pose);
    const Vector3 axis = rotate(X_WP.rotation, {0, 0, 1});
    return std::any_of(scene_.joints.begin(), scene_.joints.end(), [&](const SceneJoint& joint) {
      if (!is_endless(joint)) return false;
      const Vector3& turn = joint.axes.front().direction_W;
      const double off = length(cross(X_WP.translation - joint.anchor_W, turn));
      return length(cross(axis, turn)) < kAlongAxis && off < kOnAxis * cylinder->radius;
    });
  }

  Span or_shape(Span span) const { return span.nowhere() ? shape_.where : span; }

  void say(FactKind kind, Span where, std::string name, double value = 0) {
    draft_.say(kind, where, *collision_, std::move(name), value);
  }

  SceneDraft& draft_;
  Scene& scene_;
  MeshShapes meshes_;
  std::vector<std::size_t> counted_;  // collisions so far, of each link
  const model::Collision* collision_ = nullptr;
  SceneShape shape_;
};

}  // namespace

void add_shapes(SceneDraft& draft) { ShapeBuilder(draft).build(); }

}  // namespace rigor::simulate
