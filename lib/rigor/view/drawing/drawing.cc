// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/drawing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include <rigor/view/drawing/canvas.h>
#include <rigor/view/drawing/mark_painter.h>
#include <rigor/view/drawing/marks.h>
#include <rigor/view/drawing/materials.h>
#include <rigor/view/drawing/shape_finder.h>
#include <rigor/view/drawing/source_elements.h>

namespace rigor::view {
namespace {

using model::Id;
using model::Pose;
using model::Vector3;

constexpr std::array<std::string_view, 8> kLayerNames{"visual", "collision", "inertia",  "com",
                                                      "frames", "axes",      "contacts", "ground"};

constexpr Color kCollisionOrange{1, 0.55F, 0.1F, 0.5F};

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
        canvas_(root),
        marks_(root, frames, finder_, canvas_) {}

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
      case Layer::kCom:
      case Layer::kFrames:
      case Layer::kAxes:
      case Layer::kContacts: return marks_.draw(layer);
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
      body.name = name_of(root_, link) + '/' + named(to_string(layer), part.name.value, i);
      const auto X_WP = frames_.pose(parts[i]);
      if (!X_WP) {
        canvas_.refuse(body, "its pose is unknown");
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

  /// m. A model alone is set down on its lowest point, as `simulate` does it; a world, and a model with a floor of
  /// its own, say where the ground is.
  double ground_level() const {
    if (!root_.worlds.empty() || !planes_.empty()) return 0;
    return std::min(0.0, canvas_.lowest_shape());
  }

  void add_ground(Drawing& drawing) const {
    const Grid grid = grid_under(drawing.bounds);
    Mark mark = ground_mark(grid);
    Body body{.layer = Layer::kGround, .name = "ground", .mesh = std::move(mark.mesh)};
    body.surfaces = std::move(mark.surfaces);
    body.pose.translation = ground_origin(grid);
    body.pose.translation.z = ground_level();
    const bool covered = std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
      const Pose& pose = drawing.bodies[plane.body].pose;
      return std::abs(pose.translation.z - ground_level()) < kAbovePlane * grid.step;
    });
    if (covered) body.pose.translation.z += kAbovePlane * grid.step;
    drawing.bodies.push_back(std::move(body));
  }

  const model::Root& root_;
  const model::Frames& frames_;
  SourceElements elements_;
  Materials materials_;
  ShapeFinder finder_;
  Canvas canvas_;
  MarkPainter marks_;
  std::vector<Plane> planes_;
};

}  // namespace

std::string_view to_string(Layer layer) { return kLayerNames.at(static_cast<std::size_t>(layer)); }

std::optional<Layer> layer_named(std::string_view name) {
  const auto found = std::find(kLayerNames.begin(), kLayerNames.end(), name);
  if (found == kLayerNames.end()) return std::nullopt;
  return static_cast<Layer>(std::distance(kLayerNames.begin(), found));
}

std::vector<std::string_view> layer_names() { return {kLayerNames.begin(), kLayerNames.end()}; }

Drawing in_gray(Drawing drawing) {
  std::map<const mesh::TriangleMesh*, std::shared_ptr<const mesh::TriangleMesh>> plain;
  for (Body& body : drawing.bodies) {
    if (body.layer != Layer::kVisual) continue;
    for (Surface& surface : body.surfaces) surface = {{.a = surface.color.a}};
    if (body.mesh->corners.colors.empty()) continue;
    std::shared_ptr<const mesh::TriangleMesh>& mesh = plain[body.mesh.get()];
    if (!mesh) {
      mesh::TriangleMesh copy = *body.mesh;
      copy.corners.colors.clear();
      mesh = std::make_shared<const mesh::TriangleMesh>(std::move(copy));
    }
    body.mesh = mesh;
  }
  return drawing;
}

Drawing draw(const model::Root& root, const model::Frames& frames, const Sources& sources,
             const Files& files, const DrawingOptions& options) {
  return Draftsman(root, frames, sources, files).draw(options.layers);
}

}  // namespace rigor::view
