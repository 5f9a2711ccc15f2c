// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The order in which a scene is made. What a file has is taken by subject: build_*.cc.

#include <rigor/simulate/scene/build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/reach.h>
#include <rigor/simulate/scene/check.h>
#include <rigor/simulate/scene/draft.h>
#include <rigor/simulate/stage.h>

namespace rigor::simulate {
namespace {

using model::Id;

/// What a length is held against where nothing has a size.
constexpr double kMinSize = 0.001;  // m

/// m: a model whose origin is deeper in the ground is set down on it. As the metric's failure.
constexpr double kOriginInGround = 0.005;

bool blocks_a_run(const Fact& fact) { return fact.severe && fact.kind <= FactKind::kTooLarge; }
bool is_blocked(const Facts& facts) {
  return std::any_of(facts.begin(), facts.end(), blocks_a_run);
}

void say_unreadable(SceneDraft& draft, Span where, std::string subject, std::string name) {
  draft.facts.push_back({.kind = FactKind::kUnreadable,
                         .where = where,
                         .subject = std::move(subject),
                         .name = std::move(name),
                         .test = {}});
}

/// Models that no other one holds, of the first world, or of the top.
std::vector<Id<model::Model>> outer_models(const model::Root& root) {
  if (!root.worlds.empty()) return root.worlds.front().models;
  std::vector<Id<model::Model>> outer;
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    if (!root.models[i].parent && !root.models[i].world) outer.push_back({i});
  }
  return outer;
}

std::vector<Id<model::Model>> chosen_models(SceneDraft& draft) {
  const model::Root& root = draft.root;
  std::vector<Id<model::Model>> outer = outer_models(root);
  const std::string& wanted = draft.options.model;
  if (!wanted.empty()) {
    std::erase_if(outer, [&](Id<model::Model> id) { return root[id].name.value != wanted; });
    if (outer.empty()) say_unreadable(draft, root.site.name, wanted, "no such model");
  } else if (root.worlds.empty() && outer.size() > 1) {
    // As libsdformat: the first one counts.
    for (std::size_t i = 1; i < outer.size(); ++i) {
      const model::Model& rest = root[outer[i]];
      draft.say(FactKind::kElementIgnored, rest.name.span, rest, "model");
    }
    outer.resize(1);
  }
  for (std::size_t i = 1; i < root.worlds.size(); ++i) {
    const model::World& rest = root.worlds[i];
    draft.say(FactKind::kElementIgnored, rest.name.span, rest, "world");
  }
  if (outer.empty() && draft.facts.empty() && root.worlds.empty()) {
    say_unreadable(draft, root.site.name, {}, "no model");
  }
  return outer;
}

bool urdf_says_static(const SceneDraft& draft, const model::Model& model) {
  bool is_static = false;
  for (const model::Parameter* flag : draft.blocks.find(model, "", {"static"})) {
    is_static = read::bool_field(*flag).value;
  }
  return is_static;
}

/// Nested models belong to the outermost one; they come after the one that they are in.
void take_models(SceneDraft& draft, const std::vector<Id<model::Model>>& chosen) {
  const model::Root& root = draft.root;
  for (const Id<model::Model> id : chosen) {
    draft.model_of[id.value] = static_cast<std::uint32_t>(draft.scene.models.size());
    const model::Model& model = root[id];
    SceneModel out{.name = scoped_name(root, id), .id = id};
    out.where = model.name.written ? model.name.span : model.site.name;
    draft.scene.models.push_back(std::move(out));
  }
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    const model::Model& model = root.models[i];
    if (model.parent && model.parent.value < i && draft.takes(model.parent)) {
      draft.model_of[i] = draft.model_of[model.parent.value];
    }
    const bool outer =
        model.parent && model.parent.value < i && draft.is_static[model.parent.value];
    draft.is_static[i] = outer || model.is_static.value || urdf_says_static(draft, model);
  }
  for (SceneModel& model : draft.scene.models) model.is_static = draft.is_static[model.id.value];
}

bool is_remote(std::string_view uri) {
  return uri.starts_with("https://") || uri.starts_with("http://");
}

/// What the worlds of Gazebo's tutorials include from its own database, in the names of Gazebo Classic and of Fuel.
enum class DatabaseModel : std::uint8_t { kOther, kSun, kGroundPlane };

DatabaseModel database_model(std::string_view uri) {
  if (!is_remote(uri) && !uri.starts_with("model://")) return DatabaseModel::kOther;
  while (uri.ends_with('/')) uri.remove_suffix(1);
  const std::string_view name = uri.substr(uri.rfind('/') + 1);
  if (name == "sun" || name == "Sun") return DatabaseModel::kSun;
  if (name == "ground_plane" || name == "Ground Plane" || name == "Ground%20Plane") {
    return DatabaseModel::kGroundPlane;
  }
  return DatabaseModel::kOther;
}

/// As in the database: level, with a friction that leaves that of what stands on it to count.
void add_ground_plane(SceneDraft& draft, const model::Include& include) {
  SceneShape ground{.name = "ground_plane", .kind = HalfSpace{}, .extent = kInfinity};
  ground.X_BS = include.pose.pose.value;
  ground.surface.mu = 100;
  ground.surface.mu2 = 50;
  draft.scene.shapes.push_back(std::move(ground));
}

/// A world without a model that would have to be downloaded is still that world; a model without a part
/// is another model.
void check_includes(SceneDraft& draft) {
  const model::Root& root = draft.root;
  for (const model::Include& include : root.includes) {
    const bool here =
        include.model ? draft.takes(include.model)
                      : include.world && include.world.value == 0 && draft.options.model.empty();
    if (!here || include.followed) continue;
    const DatabaseModel known =
        include.world ? database_model(include.uri.value) : DatabaseModel::kOther;
    if (known == DatabaseModel::kSun) continue;  // a light
    if (known == DatabaseModel::kGroundPlane) {
      add_ground_plane(draft, include);
      continue;
    }
    if (include.world && is_remote(include.uri.value)) {
      draft.facts.push_back({.kind = FactKind::kElementIgnored,
                             .where = include.uri.span,
                             .subject = model::subject(root, root[include.world]),
                             .name = "include",
                             .severe = false});
      continue;
    }
    say_unreadable(draft, include.uri.written ? include.uri.span : include.site.name,
                   include.model ? model::subject(root, root[include.model])
                                 : model::subject(root, root[include.world]),
                   "include " + include.uri.value);
  }
}

/// Of what moves: the corners of its shapes' bounds, else where its bodies are.
class MovingBounds {
 public:
  void add(const Vector3& p) {
    min_ = {std::min(min_.x, p.x), std::min(min_.y, p.y), std::min(min_.z, p.z)};
    max_ = {std::max(max_.x, p.x), std::max(max_.y, p.y), std::max(max_.z, p.z)};
  }
  double diagonal() const { return length(max_ - min_); }

 private:
  Vector3 min_{kInfinity, kInfinity, kInfinity};
  Vector3 max_{-kInfinity, -kInfinity, -kInfinity};
};

mesh::Bounds bounds_in_shape(const Scene& scene, const SceneShape& shape) {
  const auto around = [](double x, double y, double z) {
    return mesh::Bounds{{-x, -y, -z}, {x, y, z}};
  };
  if (const auto* s = std::get_if<mesh::Box>(&shape.kind)) {
    return around(s->size.x / 2, s->size.y / 2, s->size.z / 2);
  }
  if (const auto* s = std::get_if<mesh::Sphere>(&shape.kind)) {
    return around(s->radius, s->radius, s->radius);
  }
  if (const auto* s = std::get_if<mesh::Cylinder>(&shape.kind)) {
    return around(s->radius, s->radius, s->length / 2);
  }
  if (const auto* s = std::get_if<mesh::Capsule>(&shape.kind)) {
    return around(s->radius, s->radius, s->length / 2 + s->radius);
  }
  if (const auto* s = std::get_if<ConvexHull>(&shape.kind)) {
    return mesh::bounds_of(scene.meshes[s->mesh].positions);
  }
  if (const auto* s = std::get_if<TriangleSoup>(&shape.kind)) {
    return mesh::bounds_of(scene.meshes[s->mesh].positions);
  }
  return around(shape.extent / 2, shape.extent / 2, shape.extent / 2);
}

double size_of(const Scene& scene) {
  MovingBounds bounds;
  std::set<const SceneBody*> shaped;
  for (const SceneShape& shape : scene.shapes) {
    if (shape.body != kWorld) shaped.insert(&scene.bodies[shape.body]);
  }
  for (const SceneBody& body : scene.bodies) {  // what has no shape has the size of its inertia
    const auto radii =
        mass::gyration_radii(body.mass.mass, mass::principal_moments(body.mass.about_com));
    const Vector3 com = transform(body.X_WB, body.mass.com);
    bounds.add(com);
    if (shaped.contains(&body)) continue;
    bounds.add(com - Vector3{radii[2], 0, 0});
    bounds.add(com + Vector3{radii[2], 0, 0});
  }
  for (const SceneShape& shape : scene.shapes) {
    if (shape.body == kWorld || !std::isfinite(shape.extent)) continue;
    const Pose X_WS = compose(scene.bodies[shape.body].X_WB, shape.X_BS);
    const mesh::Bounds box = bounds_in_shape(scene, shape);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                      (corner & 2) != 0 ? box.max.y : box.min.y,
                      (corner & 4) != 0 ? box.max.z : box.min.z};
      bounds.add(transform(X_WS, p));
    }
  }
  if (scene.bodies.empty()) return 1;
  return std::max(bounds.diagonal(), kMinSize);
}

std::uint32_t lowest_shape(const Scene& scene) {
  std::uint32_t found = 0;
  double lowest = kInfinity;
  for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
    if (scene.shapes[i].body == kWorld) continue;
    const double low = -reach(scene, scene.shapes[i], {0, 0, -1});
    if (!(low < lowest)) continue;
    lowest = low;
    found = i;
  }
  return found;
}

/// Where a model stands is up to who uses it, unless its `<pose>` says a height: a URDF has none, and
/// the root is often a hip; an SDF model's origin is often its center. As written they would begin up to
/// the waist in the earth. Of a URDF that says nothing; of an SDF model it is a warning.
void set_down(SceneDraft& draft) {
  Scene& scene = draft.scene;
  if (!draft.root.worlds.empty() || scene.models.size() != 1) return;
  const bool urdf = draft.root.format == model::Format::kUrdf;
  const double deep = -lowest_of_model(scene, 0);
  const model::Model& model = draft.root[scene.models.front().id];
  const bool placed = model.pose.pose.value.translation.z != 0;
  if (!urdf && (placed || !(deep > kOriginInGround))) return;
  Scene down = stage(scene, {.name = {}, .spawn = Spawn::kOnGround, .ground = false});
  if (!urdf && lowest_of_model(down, 0) > -deep) {
    Fact fact = about_shape(scene, lowest_shape(scene));
    fact.kind = FactKind::kSpawnedInGround;
    fact.value = deep;
    fact.limit = kOriginInGround;
    fact.severe = false;
    draft.facts.push_back(std::move(fact));
  }
  scene = std::move(down);
}

void finish(SceneDraft& draft) {
  Scene& scene = draft.scene;
  for (Fact& fact : check_counts(scene)) draft.facts.push_back(std::move(fact));
  if (is_blocked(draft.facts)) return;
  if (scene.bodies.empty()) {
    draft.facts.push_back(
        {.kind = FactKind::kNothingMoves,
         .where = scene.models.empty() ? draft.root.site.name : scene.models.front().where,
         .subject = scene.name,
         .name = {},
         .test = {},
         .severe = false});
    return;
  }
  for (Fact& fact : check_scene(scene)) draft.facts.push_back(std::move(fact));
  if (is_blocked(draft.facts)) return;
  scene.size = size_of(scene);
  scene.solver.cfm = std::min(scene.solver.cfm, softest_cfm(scene));
  set_down(draft);
}

}  // namespace

bool SceneResult::blocked() const { return is_blocked(facts); }

SceneResult build_scene(const SceneInput& input, const SceneOptions& options) {
  SceneDraft draft(input, options);
  const model::Root& root = draft.root;
  const std::vector<Id<model::Model>> chosen = chosen_models(draft);
  take_models(draft, chosen);
  draft.scene.alone = root.worlds.empty() || !options.model.empty();
  if (!draft.scene.alone) {
    draft.scene.name = root.worlds.front().name.value;
  } else if (!chosen.empty()) {
    draft.scene.name = root[chosen.front()].name.value;
  }
  check_includes(draft);
  add_physics(draft);
  check_numbers(draft);
  if (!is_blocked(draft.facts)) {  // else defaults stand where numbers are missing
    add_bodies(draft);
    add_joints(draft);
    choose_bases(draft);
    add_shapes(draft);
    finish(draft);
  }
  return {std::move(draft.scene), std::move(draft.facts)};
}

}  // namespace rigor::simulate
