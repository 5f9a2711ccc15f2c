// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/placed.h>

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <rigor/author/verbs/draft.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

constexpr std::string_view kEmitters[] = {"particle_emitter", "projector", "audio_source"};

bool is_emitter(std::string_view name) {
  return std::find(std::begin(kEmitters), std::end(kEmitters), name) != std::end(kEmitters);
}

/// Of an `<origin xyz rpy>` that the model does not know.
model::PoseField origin_of(xml::Element holder) {
  model::PoseField field;
  const auto origin = holder.child("origin");
  if (!origin) return field;
  field.site = read::site_of(*origin);
  const auto vector = [&](std::string_view name) -> model::Vector3 {
    const auto text = read::attribute_text(*origin, name);
    if (!text) return {};
    const auto numbers = write::numbers_in(text->text);
    if (!numbers || numbers->size() != 3) {
      field.malformed = true;
      return {};
    }
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  };
  const model::Vector3 xyz = vector("xyz"), rpy = vector("rpy");
  field.pose.value = {xyz, model::from_rpy(rpy.x, rpy.y, rpy.z)};
  field.pose.written = true;
  return field;
}

class PlacedCollector {
 public:
  explicit PlacedCollector(const EditedModel& edited) : edited_(edited), root_(edited.root()) {}

  std::vector<Placed> collect() && {
    each(root_.models, PlacedKind::kModel,
         [](Id<model::Model>, const model::Model&) { return Id<model::Link>{}; });
    includes();
    if (!edited_.is_urdf()) {
      each(root_.links, PlacedKind::kLink,
           [](Id<model::Link> id, const model::Link&) { return id; });
    }
    each(root_.joints, PlacedKind::kJoint,
         [&](Id<model::Joint> id, const model::Joint&) { return edited_.frames.ends(id).child; });
    each(root_.frames, PlacedKind::kFrame,
         [&](Id<model::Frame> id, const model::Frame&) { return edited_.frames.carrier(id); });
    inertials();
    parts(root_.collisions, PlacedKind::kCollision);
    parts(root_.visuals, PlacedKind::kVisual);
    if (edited_.is_urdf()) {
      blocks();
      urdf_sensors();
    } else {
      sensors();
      parts(root_.lights, PlacedKind::kLight);
      emitters();
    }
    return std::move(found_);
  }

 private:
  bool is_here(const model::Site& site, Id<model::Model> model) const {
    return root_.own(site) && edited_.inside(model);
  }
  static Id<model::Model> scope_of(const model::Model& model) { return model.parent; }
  template <class T>
  static Id<model::Model> scope_of(const T& entity) {
    return entity.model;
  }

  void add(PlacedKind kind, const model::PoseField& field, const model::Site& holder,
           const std::optional<Pose>& X_WT, Id<model::Link> link, Id<model::Model> scope,
           std::uint32_t index) {
    std::optional<Pose> X_WF;
    if (X_WT) X_WF = compose(*X_WT, inverse(field.pose.value));
    found_.push_back({kind, field, edited_.element(holder), X_WF, link, scope, index});
  }

  template <class T, class LinkOf>
  void each(const std::vector<T>& all, PlacedKind kind, LinkOf link_of) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      const Id<T> id{i};
      if (!is_here(all[i].site, scope_of(all[i]))) continue;
      if constexpr (std::is_same_v<T, model::Model>) {
        if (all[i].include != 0xffffffffU) continue;  // its include has the pose
      }
      add(kind, all[i].pose, all[i].site, edited_.frames.pose(id), link_of(id, all[i]),
          scope_of(all[i]), i);
    }
  }

  void includes() {
    for (std::uint32_t i = 0; i < root_.includes.size(); ++i) {
      const model::Include& include = root_.includes[i];
      if (!is_here(include.site, include.model)) continue;
      const auto X_WT = include.loaded ? edited_.frames.pose(include.loaded) : std::nullopt;
      add(PlacedKind::kInclude, include.pose, include.site, X_WT, {}, include.model, i);
    }
  }

  void inertials() {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      if (!link.inertial.written || !is_here(link.inertial.site, link.model)) continue;
      const auto X_WL = edited_.frames.pose(Id<model::Link>{i});
      found_.push_back({PlacedKind::kInertial,
                        link.inertial.pose,
                        edited_.element(link.inertial.site),
                        X_WL,
                        {i},
                        link.model,
                        i});
    }
  }

  template <class T>
  void parts(const std::vector<T>& all, PlacedKind kind) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (!all[i].link || !is_here(all[i].site, root_[all[i].link].model)) continue;
      add(kind, all[i].pose, all[i].site, edited_.frames.pose(Id<T>{i}), all[i].link,
          root_[all[i].link].model, i);
    }
  }

  void sensors() {
    for (std::uint32_t i = 0; i < root_.sensors.size(); ++i) {
      const model::Sensor& sensor = root_.sensors[i];
      Id<model::Link> link = sensor.link;
      if (!link && sensor.joint) link = edited_.frames.ends(sensor.joint).child;
      if (!link || !is_here(sensor.site, root_[link].model)) continue;
      add(PlacedKind::kSensor, sensor.pose, sensor.site, edited_.frames.pose(Id<model::Sensor>{i}),
          link, root_[link].model, i);
      found_.back().on_joint = static_cast<bool>(sensor.joint);
    }
  }

  /// The frame that a pose with that `relative_to` is in.
  std::optional<Pose> frame_of(const std::string& relative_to, Id<model::Link> link) const {
    if (relative_to.empty()) return edited_.frames.pose(link);
    std::optional<Pose> X_WF;
    std::visit(
        [&](const auto& frame) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(frame)>, std::monostate>)
            X_WF = edited_.frames.pose(frame);
        },
        edited_.frames.names().find({root_[link].model, {}}, relative_to));
    return X_WF;
  }

  /// What the model does not know, with a `<pose>` as of SDF.
  void add_unknown(PlacedKind kind, xml::Element holder, Id<model::Link> link) {
    const model::PoseField field = sdf_pose_in(holder);
    found_.push_back(
        {kind, field, holder, frame_of(field.relative_to.value, link), link, root_[link].model, 0});
  }

  void emitters() {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      if (!is_here(link.site, link.model) || root_[link.model].version == 0) continue;
      for (const xml::Element child : edited_.element(link.site).children()) {
        if (is_emitter(child.name())) add_unknown(PlacedKind::kEmitter, child, {i});
      }
    }
  }

  /// What libsdformat copies from a block into the link, as it is written there.
  void blocks() {
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const Id<model::Link> link = edited_.link(block.reference.value);
      if (!link || !is_here(block.site, root_[link].model)) continue;
      for (const xml::Element child : edited_.element(block.site).children()) {
        const std::string_view name = child.name();
        if (name == "sensor") add_unknown(PlacedKind::kSensor, child, link);
        if (name == "light") add_unknown(PlacedKind::kLight, child, link);
        if (is_emitter(name)) add_unknown(PlacedKind::kEmitter, child, link);
      }
    }
  }

  /// `<sensor>` of the robot, with its `<parent link>` and `<origin>`.
  void urdf_sensors() {
    if (!root_.own(root_[edited_.model].site)) return;
    for (const xml::Element child : edited_.element(root_[edited_.model].site).children()) {
      if (child.name() != "sensor") continue;
      const Id<model::Link> link = parent_of_sensor(child);
      if (!link) continue;
      found_.push_back({PlacedKind::kSensor, origin_of(child), child, edited_.frames.pose(link),
                        link, root_[link].model, 0});
    }
  }

  /// A joint's frame is that of the link it carries.
  Id<model::Link> parent_of_sensor(xml::Element sensor) const {
    const auto parent = sensor.child("parent");
    if (!parent) return {};
    if (const auto link = parent->attribute("link")) return edited_.link(link->value());
    const auto joint = parent->attribute("joint");
    const Id<model::Joint> id = joint ? edited_.joint(joint->value()) : Id<model::Joint>{};
    return id ? edited_.frames.ends(id).child : Id<model::Link>{};
  }

  const EditedModel& edited_;
  const model::Root& root_;
  std::vector<Placed> found_;
};

}  // namespace

std::vector<Placed> placed_in(const EditedModel& edited) {
  return PlacedCollector(edited).collect();
}

std::optional<std::string> included_part(const EditedModel& edited) {
  for (const model::Include& include : edited.root().includes) {
    if (edited.inside(include.model)) return include.path;
  }
  return std::nullopt;
}

}  // namespace rigor::author
