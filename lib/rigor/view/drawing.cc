// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

#include <rigor/mass/resolve.h>
#include <rigor/view/canvas.h>
#include <rigor/view/drawing_marks.h>
#include <rigor/view/materials.h>
#include <rigor/view/shape_finder.h>
#include <rigor/view/source_elements.h>
#include <rigor/view/turn.h>

namespace rigor::view {
namespace {

using model::Id;
using model::Pose;
using model::Vector3;

constexpr std::array<std::string_view, 7> kLayerNames{"visual", "collision", "inertia", "com",
                                                      "frames", "axes",      "ground"};

// Of the diagonal of a model.
constexpr double kFrameLength = 0.06;
constexpr double kAxisLength = 0.1;
constexpr double kComRadius = 0.01;

constexpr Color kCollisionOrange{1, 0.55F, 0.1F, 0.5F};
constexpr Color kInertiaPurple{0.65F, 0.25F, 0.85F, 0.5F};

/// A plane is drawn as far around the rest as this many of its diagonals.
constexpr double kPlaneReach = 2;
/// Where there is nothing else, m.
constexpr double kLonePlaneReach = 5;
/// The ground lies so much above a plane of the model in the same place, of a step of its grid.
constexpr double kAbovePlane = 1e-3;

std::string named(std::string_view kind, const std::string& name, std::size_t index) {
  return std::string(kind) + ' ' + (name.empty() ? std::to_string(index + 1) : name);
}

class Draftsman {
 public:
  Draftsman(const model::Root& root, const model::Frames& frames, const Sources& sources,
            const Files& files)
      : root_(root),
        frames_(frames),
        elements_(sources),
        materials_(root, elements_, files),
        finder_(elements_, files),
        canvas_(root) {}

  Drawing draw(const std::set<Layer>& layers) {
    for (const Layer layer : layers) draw_layer(layer);
    finish_planes();
    Drawing drawing = canvas_.drawing();
    if (layers.contains(Layer::kGround)) add_ground(drawing);
    return drawing;
  }

 private:
  void draw_layer(Layer layer) {
    switch (layer) {
      case Layer::kVisual: return draw_shapes<model::Visual>(layer);
      case Layer::kCollision: return draw_shapes<model::Collision>(layer);
      case Layer::kInertia:
      case Layer::kCom: return draw_masses(layer);
      case Layer::kFrames: return draw_frames();
      case Layer::kAxes: return draw_axes();
      case Layer::kGround: return;  // when all else is known
    }
  }

  template <class Part>
  void draw_shapes(Layer layer) {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const Id<model::Link> link{i};
      if constexpr (std::is_same_v<Part, model::Visual>) {
        draw_parts(layer, link, root_[link].visuals);
      } else {
        draw_parts(layer, link, root_[link].collisions);
      }
    }
  }

  template <class Part>
  void draw_parts(Layer layer, Id<model::Link> link, const std::vector<Id<Part>>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Part& part = root_[parts[i]];
      if (part.geometry.explicitly_empty) continue;
      Body body{.layer = layer, .link = link, .where = part.site.tag};
      body.name = link_name(link) + '/' + named(to_string(layer), part.name.value, i);
      const auto X_WP = frames_.pose(parts[i]);
      if (!X_WP) {
        canvas_.refuse(body, "where it is cannot be told");
        continue;
      }
      FoundShape found = finder_.find(part.geometry);
      if (!found.mesh) {
        canvas_.refuse(body, std::move(found.why));
        continue;
      }
      body.pose = compose(*X_WP, found.offset);
      body.mesh = std::move(found.mesh);
      body.scale = found.scale;
      if constexpr (std::is_same_v<Part, model::Visual>) {
        body.surfaces = materials_.of(part, *body.mesh);
      } else {
        body.surfaces = {{kCollisionOrange}};
      }
      if (!found.plane) {
        canvas_.add(std::move(body));
      } else if (canvas_.put_off(std::move(body))) {
        const bool unbounded = layer == Layer::kCollision && !found.plane->written;
        planes_.push_back({canvas_.bodies().size() - 1, *found.plane});
        if (unbounded) planes_.back().size.x = planes_.back().size.y = HUGE_VAL;
      }
    }
  }

  void draw_masses(Layer layer) {
    const Mark com = layer == Layer::kCom ? com_mark() : Mark();
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const Id<model::Link> link{i};
      const auto X_WL = frames_.pose(link);
      if (!X_WL || model::is_static(root_, root_[link].model)) continue;
      const mass::MassProperties mass = mass::resolve(root_, frames_, link, {}).body;
      if (mass.mass == 0 && mass.about_com == mass::Inertia()) continue;  // URDF: none at all
      Body body{.layer = layer, .link = link, .where = root_[link].inertial.site.tag};
      if (body.where.nowhere()) body.where = root_[link].site.tag;
      body.name = link_name(link) + (layer == Layer::kCom ? "/centre of mass" : "/inertia");
      if (layer == Layer::kCom) {
        body.pose = {transform(*X_WL, mass.com), X_WL->rotation};
        add_mark(std::move(body), com, kComRadius);
      } else {
        add_inertia(std::move(body), *X_WL, mass);
      }
    }
  }

  void add_inertia(Body body, const Pose& X_WL, const mass::MassProperties& mass) {
    if (!(mass.mass > 0) || !mass::judge(mass).possible()) {
      canvas_.refuse(body, "no rigid body has such a mass and inertia");
      return;
    }
    const mass::PrincipalAxes principal = mass::principal_axes(mass.about_com);
    const auto sides = mass::equivalent_box(mass.mass, principal.moments);
    body.pose = compose(X_WL, {mass.com, turn_to(principal.axes)});
    body.scale = {sides[0], sides[1], sides[2]};
    body.mesh = finder_.unit_box();
    body.surfaces = {{kInertiaPurple}};
    canvas_.add(std::move(body));
  }

  void draw_frames() {
    const Mark mark = frame_mark();
    note_places();
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const Id<model::Link> link{i};
      const auto X_WL = frames_.pose(link);
      if (!X_WL) continue;
      Body body{.layer = Layer::kFrames, .link = link, .pose = *X_WL};
      body.name = link_name(link) + "/frame";
      body.where = root_[link].site.tag;
      add_mark(std::move(body), mark, kFrameLength);
    }
  }

  void draw_axes() {
    const Mark mark = axis_mark();
    note_places();
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const Id<model::Joint> id{i};
      const model::Joint& joint = root_[id];
      const auto X_WJ = frames_.pose(id);
      if (!X_WJ || joint.type == model::JointType::kFixed) continue;
      for (std::size_t a = 0; a < joint.axes.size(); ++a) {
        const auto axis = frames_.axis(id, a);
        if (!axis) continue;
        Body body{.layer = Layer::kAxes, .link = frames_.ends(id).child, .joint = id};
        body.pose = {X_WJ->translation, turn_from_z(*axis)};
        body.where = joint.axes[a].site.tag;
        body.name = scoped_name(root_, joint.model) + "/joint " + joint.name.value +
                    (a == 0 ? "/axis" : "/axis2");
        add_mark(std::move(body), mark, kAxisLength);
      }
    }
  }

  void add_mark(Body body, const Mark& mark, double share) {
    const double size = share * canvas_.size_around(body.link);
    body.mesh = mark.mesh;
    body.surfaces = mark.surfaces;
    body.scale = {size, size, size};
    canvas_.add(std::move(body));
  }

  /// A model whose shapes are not shown is as large as its frames lie apart.
  void note_places() {
    if (std::exchange(noted_, true)) return;
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const auto X_WL = frames_.pose(Id<model::Link>{i});
      if (X_WL) canvas_.note(Id<model::Link>{i}, X_WL->translation);
    }
  }

  std::string link_name(Id<model::Link> link) const {
    return scoped_name(root_, root_[link].model) + "/link " + root_[link].name.value;
  }

  struct Plane {
    std::size_t body = 0;
    PlaneSize size;
  };

  /// As large as they are written, but not much larger than what else there is.
  void finish_planes() {
    if (planes_.empty()) return;
    const mesh::Bounds bounds = canvas_.bounds();
    const bool lone = !(bounds.min.x <= bounds.max.x);
    for (const Plane& plane : planes_) {
      Body& body = canvas_.bodies()[plane.body];
      const Vector3 middle =
          lone ? Vector3() : transform(inverse(body.pose), 0.5 * (bounds.min + bounds.max));
      const double reach = lone ? kLonePlaneReach : kPlaneReach * mesh::diagonal(bounds);
      Vector3 shift;
      body.scale = {1, 1, 1};
      clip(plane.size.x, middle.x, reach, body.scale.x, shift.x);
      clip(plane.size.y, middle.y, reach, body.scale.y, shift.y);
      body.pose = compose(body.pose, {shift, {}});
    }
    if (lone) canvas_.bound_all();
  }

  static void clip(double size, double middle, double reach, double& side, double& shift) {
    const double half = std::min(size / 2, reach);
    side = 2 * half;
    const double free = size / 2 - half;
    shift = std::clamp(middle, -free, free);
  }

  void add_ground(Drawing& drawing) const {
    const Grid grid = grid_under(drawing.bounds);
    Mark mark = ground_mark(grid);
    Body body{.layer = Layer::kGround, .name = "ground", .mesh = std::move(mark.mesh)};
    body.surfaces = std::move(mark.surfaces);
    body.pose.translation = ground_origin(grid);
    const bool covered = std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      const Pose& pose = drawing.bodies[plane.body].pose;
      return std::abs(pose.translation.z) < kAbovePlane * grid.step;
    });
    if (covered) body.pose.translation.z = kAbovePlane * grid.step;
    drawing.bodies.push_back(std::move(body));
  }

  const model::Root& root_;
  const model::Frames& frames_;
  SourceElements elements_;
  Materials materials_;
  ShapeFinder finder_;
  Canvas canvas_;
  std::vector<Plane> planes_;
  bool noted_ = false;
};

}  // namespace

std::string_view to_string(Layer layer) { return kLayerNames.at(static_cast<std::size_t>(layer)); }

std::optional<Layer> layer_named(std::string_view name) {
  const auto found = std::find(kLayerNames.begin(), kLayerNames.end(), name);
  if (found == kLayerNames.end()) return std::nullopt;
  return static_cast<Layer>(std::distance(kLayerNames.begin(), found));
}

std::vector<std::string_view> layer_names() { return {kLayerNames.begin(), kLayerNames.end()}; }

Drawing draw(const model::Root& root, const model::Frames& frames, const Sources& sources,
             const Files& files, const DrawingOptions& options) {
  return Draftsman(root, frames, sources, files).draw(options.layers);
}

}  // namespace rigor::view
