// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include <rigor/read/include_parameters.h>
#include <rigor/read/include_size.h>
#include <rigor/read/merge.h>
#include <rigor/read/rename.h>
#include <rigor/read/sdf_reader.h>
#include <rigor/read/urdf.h>
#include <rigor/schema/gazebo_database.h>
#include <rigor/schema/value.h>
#include <rigor/text/digest.h>

namespace rigor::read {

using model::Id;

namespace {

/// A pose from its numbers: x y z and roll pitch yaw (radians, or degrees if so said), or x y z and
/// a quaternion x y z w.
model::Pose to_pose(const schema::PoseNumbers& pose, double angle_unit) {
  const auto& n = pose.numbers;
  const model::Vector3 translation{n[0], n[1], n[2]};
  if (pose.count == 7) return {translation, model::normalized({n[6], n[3], n[4], n[5]})};
  return {translation, model::from_rpy(n[3] * angle_unit, n[4] * angle_unit, n[5] * angle_unit)};
}

model::Trajectory read_trajectory(xml::Element element) {
  model::Trajectory trajectory;
  trajectory.site = site_of(element);
  trajectory.type = string_field(attribute_text(element, "type"));
  for (const xml::Element child : element.children()) {
    if (child.name() != "waypoint") continue;
    trajectory.times.push_back(number_field(child_text(child, "time"), 0));
  }
  return trajectory;
}

constexpr double kDegree = 0.017453292519943295;  // π/180, as libsdformat converts

/// 1.7 is the last version that Gazebo classic reads. gz sim has no database of `model://` names.
constexpr int kLastOfGazeboClassic = 7;

bool downloaded_by_gazebo_classic(std::string_view uri, int version) {
  constexpr std::string_view kModel = "model://";
  if (version > kLastOfGazeboClassic || !uri.starts_with(kModel)) return false;
  uri.remove_prefix(kModel.size());
  while (uri.ends_with('/')) uri.remove_suffix(1);
  return schema::in_gazebo_database(uri);
}

}  // namespace

model::PoseField SdfReader::read_pose(xml::Element parent) const {
  model::PoseField field;
  const bool attributes = version_ == 0;  // SDF 1.0: <origin pose="…"/>
  const auto element = parent.child(attributes ? "origin" : "pose");
  if (!element) return field;
  field.site = site_of(*element);
  // Consumers upgrade an old file in memory: `frame` becomes `relative_to`, and one that is there
  // already stays, though its version did not know it.
  field.relative_to = string_field(attribute_text(*element, "relative_to"));
  if (version_ < 7 && !field.relative_to.written) {
    field.relative_to = string_field(attribute_text(*element, "frame"));
  }

  std::optional<Text> text = Text{element->text(), element->text_span()};
  if (attributes) text = attribute_text(*element, "pose");
  if (!text) return field;
  if (trimmed(text->text).empty()) {
    field.pose.span = text->span;
    field.pose.written = true;
    return field;
  }
  const auto format = attribute_text(*element, "rotation_format");
  const bool quaternion = format && trimmed(format->text) == "quat_xyzw";
  const auto parsed =
      schema::parse_pose(text->text, quaternion ? schema::RotationFormat::kQuatXyzw
                                                : schema::RotationFormat::kEulerRpy);
  const bool degrees = bool_field(attribute_text(*element, "degrees"), false).value;
  if (const auto* numbers = std::get_if<schema::PoseNumbers>(&parsed)) {
    field.pose = {to_pose(*numbers, degrees ? kDegree : 1), text->span, true};
  }
  return field;
}

std::size_t SdfReader::parts() const {
  return root_.models.size() + root_.links.size() + root_.joints.size() + root_.frames.size() +
         root_.collisions.size() + root_.visuals.size() + root_.sensors.size() +
         root_.lights.size() + root_.plugins.size() + root_.includes.size();
}

void SdfReader::tell_too_much(Span where) {
  const auto is_reported = [](const Fact& fact) { return fact.kind == FactKind::kTooMuchIncluded; };
  if (std::any_of(facts_.begin(), facts_.end(), is_reported)) return;
  facts_.push_back({FactKind::kTooMuchIncluded, where, {}, {}});
}

/// Asked before a file is followed, so that what cannot be held costs nothing.
bool SdfReader::fits(const File& file, Span where) {
  const std::size_t now = parts();
  if (!is_included()) max_ = now + kMaxIncludedParts - std::min(brought_, kMaxIncludedParts);
  if (now + parts_with_includes(reader_, file) <= max_) return true;
  tell_too_much(where);
  return false;
}

/// Only files that include each other are larger than counted before.
bool SdfReader::is_full(Span where) {
  if (!is_included() || parts() < max_) return false;
  tell_too_much(where);
  return true;
}

void SdfReader::read_top(xml::Element sdf) {
  bool first = true;
  for (const xml::Element child : sdf.children()) {
    const std::string_view name = child.name();
    if (name == "world") {
      read_world(child);
    } else if (name ==
               "include") {  // not in the specification; libsdformat resolves it all the same
      read_include(child, {});
    } else if (name == "model" || name == "actor" || name == "light") {
      if (!first) {
        facts_.push_back({FactKind::kMoreAtTopLevel, child.name_span(), std::string(name), {}});
      }
      first = false;
      if (name == "model") read_model(child, {});
      if (name == "actor") read_actor(child, {});
      if (name == "light") read_light(child, {});
    }
  }
}

Id<model::Model> SdfReader::read_included(xml::Element sdf, Scope scope) {
  if (const auto element = sdf.child("model")) return read_model(*element, scope);
  if (const auto element = sdf.child("actor")) read_actor(*element, scope);
  if (const auto element = sdf.child("light")) read_light(*element, {});
  return {};
}

/// Up to SDF 1.5 it stands in `<physics>`, of which the one marked as default counts, else the first; one that
/// the world has all the same comes before it. In 1.0 it is an attribute.
model::Field<model::Vector3> SdfReader::gravity_of(xml::Element world) const {
  constexpr model::Vector3 kStandard{0, 0, -9.8};
  std::optional<xml::Element> holder = world;
  if (version_ <= 5 && !world.child("gravity")) {
    holder.reset();
    for (const xml::Element child : world.children()) {
      if (child.name() != "physics") continue;
      const bool is_default = bool_field(attribute_text(child, "default"), false).value;
      if (!holder || is_default) holder = child;
      if (is_default) break;
    }
  }
  if (!holder) return {kStandard, {}, false};
  const auto element = holder->child("gravity");
  const auto attribute = element ? value_attribute(*element, "xyz") : std::nullopt;
  return vector_field(attribute ? attribute : child_text(*holder, "gravity"), kStandard);
}

/// Up to SDF 1.3 each engine has a step of its own; only ODE's counts here.
std::optional<Text> SdfReader::step_text(xml::Element physics) const {
  if (version_ > 3) return child_text(physics, "max_step_size");
  const auto ode = physics.child("ode");
  const auto solver = ode ? ode->child("solver") : std::nullopt;
  return solver ? child_text(*solver, "dt") : std::nullopt;
}

model::WorldState SdfReader::read_state(xml::Element element) {
  model::WorldState state;
  state.inserts = element.child("insertions").has_value();
  for (const xml::Element child : element.children()) {
    if (child.name() != "model") continue;
    state.models.push_back({site_of(child), string_field(attribute_text(child, "name"))});
  }
  return state;
}

void SdfReader::read_world(xml::Element element) {
  const Id<model::World> id = next_id(root_.worlds);
  model::World world;
  world.site = site_of(element);
  world.name = string_field(attribute_text(element, "name"));
  world.gravity = gravity_of(element);
  if (const auto place = element.child("spherical_coordinates")) {
    world.globe_position = {number_field(child_text(*place, "latitude_deg"), 0),
                            number_field(child_text(*place, "longitude_deg"), 0)};
  }
  for (const xml::Element child : element.children()) {
    if (const auto name = child.attribute("name")) world.names.emplace_back(name->value());
    if (child.name() == "state") world.states.push_back(read_state(child));
  }
  root_.worlds.push_back(std::move(world));
  const Scope scope{{}, id};
  for (const xml::Element child : element.children()) {
    if (is_full(child.name_span())) return;
    const std::string_view name = child.name();
    if (name == "model") {
      read_model(child, scope);
    } else if (name == "include") {
      read_include(child, scope);
    } else if (name == "frame") {
      read_frame(child, scope);
    } else if (name == "joint") {
      read_joint(child, scope);
    } else if (name == "light") {
      read_light(child, {});
    } else if (name == "actor") {
      read_actor(child, scope);
    } else if (name == "physics") {
      read_physics(child, scope);
    } else if (name == "plugin") {
      read_plugin(child, {.world = id});
    }
  }
}

Id<model::Model> SdfReader::read_model(xml::Element element, Scope scope) {
  const Id<model::Model> id = next_id(root_.models);
  model::Model model;
  model.site = site_of(element);
  model.version = version_;
  model.name = string_field(attribute_text(element, "name"));
  model.parent = scope.model;
  model.world = scope.world;
  model.is_static = bool_field(child_text(element, "static"), false);
  model.self_collide = bool_field(child_text(element, "self_collide"), false);
  model.canonical_link = string_field(attribute_text(element, "canonical_link"));
  model.placement_frame = string_field(attribute_text(element, "placement_frame"));
  model.pose = read_pose(element);
  root_.models.push_back(std::move(model));
  if (scope.model) {
    root_.models[scope.model.value].models.push_back(id);
  } else if (scope.world) {
    root_.worlds[scope.world.value].models.push_back(id);
  }
  read_model_parts(element, id);
  return id;
}

void SdfReader::read_model_parts(xml::Element element, Id<model::Model> id) {
  const Scope scope{id, root_[id].world};
  for (const xml::Element child : element.children()) {
    if (is_full(child.name_span())) return;
    const std::string_view name = child.name();
    if (name == "link") {
      read_link(child, id);
    } else if (name == "joint") {
      read_joint(child, scope);
    } else if (name == "frame") {
      read_frame(child, scope);
    } else if (name == "model") {
      read_model(child, scope);
    } else if (name == "include") {
      read_include(child, scope);
    } else if (name == "plugin") {
      read_plugin(child, {.model = id});
    }
  }
  if (version_ < 7) rename_siblings(root_, id);
}

model::Field<std::string> include_uri(xml::Element include) {
  if (const auto uri = child_text(include, "uri")) return string_field(uri);
  return string_field(value_attribute(include, "filename"));  // SDF 1.0
}

void SdfReader::read_include(xml::Element element, Scope scope) {
  model::Include include;
  include.site = site_of(element);
  include.uri = include_uri(element);
  include.name = string_field(child_text(element, "name"));
  include.placement_frame = string_field(child_text(element, "placement_frame"));
  include.is_static = bool_field(child_text(element, "static"), false);
  include.merge = bool_field(attribute_text(element, "merge"), false);
  include.pose = read_pose(element);
  include.model = scope.model;
  include.world = scope.world;
  const auto index = static_cast<std::uint32_t>(root_.includes.size());
  root_.includes.push_back(include);
  include.followed = follow(include, element, scope);
  root_.includes[index] = include;
  if (!include.loaded) return;
  override_model(include, index);
  for (const xml::Element child : element.children()) {
    if (child.name() == "plugin") read_plugin(child, {.model = include.loaded});
  }
  if (include.merge.value && scope.model) merge_into_parent(root_, include.loaded);
}

/// The one that is read, or what parameters of an include have made of it.
const File* SdfReader::file_of(xml::Element element) const {
  for (const File* file : reader_.workspace.files()) {
    if (file->document && file->source == element.name_span().source) return file;
  }
  return nullptr;
}

bool SdfReader::follow(model::Include& include, xml::Element element, Scope scope) {
  if (include.uri.value.empty()) return false;
  const Span where = include.uri.span;
  const Resolution& found =
      reader_.workspace.resolve(reader_.resolver, include.uri.value, files_.back());
  if (!found.path) {
    const bool is_remote =
        found.remote || downloaded_by_gazebo_classic(include.uri.value, version_);
    Fact fact{is_remote ? FactKind::kUnfollowedInclude : FactKind::kIncludeNotFound,
              where,
              include.uri.value,
              {}};
    for (const Tried& tried : found.tried)
      fact.tried.push_back(tried.path + " (" + tried.origin + ")");
    facts_.push_back(std::move(fact));
    return false;
  }
  const File* file = open_model(reader_, *found.path, where, facts_);
  if (file == nullptr || !may_follow(include, file->path) || !fits(*file, where)) return false;
  include.path = file->path;
  file = with_parameters(*file, element);
  if (!file->document || !file->document->root()) return false;

  const xml::Element top = *file->document->root();
  std::vector<std::string> files = files_;
  files.push_back(include.path);
  const std::size_t before = parts();
  if (top.name() == "robot") {
    include.loaded = read_urdf(root_, top, scope);
    brought_ += parts() - before;
    return true;
  }
  const auto version = schema::parse_version(string_field(attribute_text(top, "version")).value);
  const std::size_t first_fact = facts_.size();
  SdfReader inner(reader_, root_, facts_, std::move(files),
                  version ? version->minor : reader_.sdf.latest().minor, max_);
  include.loaded = inner.read_included(top, scope);
  brought_ += parts() - before;
  // What is wrong inside is reported when that file is checked, but for what follows from where the
  // includes began: no other file that anybody checks may show it.
  const auto inside = [](const Fact& fact) {
    return fact.kind != FactKind::kIncludeCycle && fact.kind != FactKind::kTooMuchIncluded &&
           fact.kind != FactKind::kIncludeTooDeep;
  };
  facts_.erase(std::remove_if(facts_.begin() + static_cast<std::ptrdiff_t>(first_fact),
                              facts_.end(), inside),
               facts_.end());
  for (std::size_t i = first_fact; i < facts_.size(); ++i) facts_[i].where = where;
  return true;
}

namespace {

/// The parameter's element name and what it is for: `<visual> of 'base::v'`.
std::string described_parameter(xml::Element parameter) {
  const std::string tag = "<" + std::string(parameter.name()) + ">";
  if (const auto id = parameter.attribute("element_id")) {
    return id->value().empty() ? tag : tag + " of '" + std::string(id->value()) + "'";
  }
  const auto parent = parameter.parent();
  if (!parent || parent->name() == "experimental:params") return tag;
  return tag + " in " + described_parameter(*parent);
}

}  // namespace

/// The included file as the parameters of the include change it.
const File* SdfReader::with_parameters(const File& file, xml::Element include) {
  const File* includer = include.child("experimental:params") ? file_of(include) : nullptr;
  if (includer == nullptr) return &file;
  IncludeChanges changes =
      with_include_parameters(*file.document, *includer->document, include, reader_.sdf);
  for (const SkippedParameter& skipped : changes.skipped) {
    Fact fact{FactKind::kParameterSkipped,
              skipped.element.name_span(),
              described_parameter(skipped.element),
              {skipped.detail}};
    fact.parameter_fault = skipped.fault;
    facts_.push_back(std::move(fact));
  }
  if (!changes.bytes) return &file;
  // In the same folder, so that what it refers to is found.
  const std::string path = file.path + '#' + hex(digest_of(*changes.bytes));
  return &reader_.workspace.put(path, *std::move(changes.bytes));
}

bool SdfReader::may_follow(const model::Include& include, const std::string& path) {
  const auto cycle = std::find(files_.begin(), files_.end(), path);
  if (cycle != files_.end()) {
    Fact fact{FactKind::kIncludeCycle, include.uri.span, path, {cycle, files_.end()}};
    fact.tried.push_back(path);
    facts_.push_back(std::move(fact));
    return false;
  }
  if (files_.size() >= kMaxIncludeDepth) {
    facts_.push_back({FactKind::kIncludeTooDeep, include.uri.span, include.uri.value, {}});
    return false;
  }
  return true;
}

void SdfReader::override_model(const model::Include& include, std::uint32_t index) {
  model::Model& model = root_.models[include.loaded.value];
  model.include = index;
  if (!include.name.value.empty()) model.name = include.name;
  if (include.is_static.written) model.is_static = include.is_static;
  if (!include.pose.site.span.nowhere()) model.pose = include.pose;
  if (include.placement_frame.written) model.placement_frame = include.placement_frame;
}

void SdfReader::read_frame(xml::Element element, Scope scope) {
  const Id<model::Frame> id = next_id(root_.frames);
  model::Frame frame;
  frame.site = site_of(element);
  frame.name = string_field(attribute_text(element, "name"));
  frame.model = scope.model;
  frame.world = scope.world;
  frame.attached_to = string_field(attribute_text(element, "attached_to"));
  frame.pose = read_pose(element);
  root_.frames.push_back(std::move(frame));
  auto& siblings =
      scope.model ? root_.models[scope.model.value].frames : root_.worlds[scope.world.value].frames;
  siblings.push_back(id);
}

void SdfReader::read_actor(xml::Element element, Scope scope) {
  model::Actor& actor = root_.actors.emplace_back();
  actor.site = site_of(element);
  actor.name = string_field(attribute_text(element, "name"));
  actor.world = scope.world;
  for (const xml::Element child : element.children()) {
    const auto name = attribute_text(child, "name");
    if (child.name() == "animation" && name) actor.animations.push_back(string_field(name));
  }
  const auto script = element.child("script");
  if (!script) return;
  for (const xml::Element child : script->children()) {
    if (child.name() == "trajectory") actor.trajectories.push_back(read_trajectory(child));
  }
}

void SdfReader::read_physics(xml::Element element, Scope scope) {
  model::Physics physics;
  physics.site = site_of(element);
  physics.name = string_field(attribute_text(element, "name"));
  physics.type = string_field(attribute_text(element, "type"), "ode");
  physics.is_default = bool_field(attribute_text(element, "default"), false);
  physics.max_step_size = number_field(step_text(element), 0.001);
  physics.real_time_factor = number_field(child_text(element, "real_time_factor"), 1);
  physics.world = scope.world;
  root_.physics.push_back(std::move(physics));
}

void SdfReader::read_light(xml::Element element, Id<model::Link> link) {
  model::Light light;
  light.site = site_of(element);
  light.name = string_field(attribute_text(element, "name"));
  light.type = string_field(attribute_text(element, "type"));
  light.link = link;
  light.pose = read_pose(element);
  light.direction = vector_field(child_text(element, "direction"), {0, 0, -1});
  if (const auto spot = element.child("spot")) {
    light.spot_inner_angle = number_field(child_text(*spot, "inner_angle"), 0);
    light.spot_outer_angle = number_field(child_text(*spot, "outer_angle"), 0);
  }
  root_.lights.push_back(std::move(light));
}

void SdfReader::read_plugin(xml::Element element, model::Plugin plugin) {
  plugin.site = site_of(element);
  plugin.name = string_field(attribute_text(element, "name"));
  plugin.filename = string_field(attribute_text(element, "filename"));
  plugin.parameters = parameters_in(element);
  root_.plugins.push_back(std::move(plugin));
}

}  // namespace rigor::read
