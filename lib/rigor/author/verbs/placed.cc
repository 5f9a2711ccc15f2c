// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/placed.h>

#include <type_traits>
#include <utility>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

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
    sensors();
    parts(root_.lights, PlacedKind::kLight);
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
    found_.push_back({kind, &field, edited_.element(holder), X_WF, link, scope, index});
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
                        &link.inertial.pose,
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

  /// Of a URDF those of `<gazebo>` blocks are in the frame of the link that the block names.
  void sensors() {
    for (std::uint32_t i = 0; i < root_.sensors.size(); ++i) {
      const model::Sensor& sensor = root_.sensors[i];
      Id<model::Link> link = sensor.link;
      if (!link && sensor.joint) link = edited_.frames.ends(sensor.joint).child;
      if (!link && !sensor.gazebo_reference.empty()) link = edited_.link(sensor.gazebo_reference);
      if (!link || !is_here(sensor.site, root_[link].model)) continue;
      if (sensor.link || sensor.joint) {
        add(PlacedKind::kSensor, sensor.pose, sensor.site,
            edited_.frames.pose(Id<model::Sensor>{i}), link, root_[link].model, i);
      } else {
        found_.push_back({PlacedKind::kSensor, &sensor.pose, edited_.element(sensor.site),
                          edited_.frames.pose(link), link, root_[link].model, i});
      }
    }
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
