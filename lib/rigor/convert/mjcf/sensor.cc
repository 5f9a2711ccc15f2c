// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Sensors that MuJoCo has as well, on a site or as a camera; frames as sites. Rates, noise and topics are
// the simulator's.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <rigor/convert/mjcf/draft.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::Pose;

/// SDF's camera looks along x, with z up; MuJoCo's along -z, with y up.
constexpr model::Quaternion kLooksAlongX{0.5, 0.5, -0.5, -0.5};

/// The sides of a picture where the file has none.
constexpr double kWidth = 320, kHeight = 240;

class MjcfSensorMaker {
 public:
  MjcfSensorMaker(MjcfDraft& draft, std::uint32_t body)
      : draft_(draft), index_(body), body_(draft.robot().bodies[body]) {}

  std::vector<MjcfElement> make() {
    add_frames();
    const model::Link* link = draft_.entities.link(body_.span);
    if (link != nullptr) {
      for (const auto id : link->sensors) add(draft_.root()[id]);
      for (const model::Sensor& sensor : draft_.root().sensors) {
        const bool of_block = !sensor.gazebo_reference.empty() && !sensor.joint;
        if (of_block && sensor.gazebo_reference == link->name.value) add(sensor);
      }
    }
    if (body_.carrier != robot::kNoIndex) add_of_joint(draft_.robot().joints[body_.carrier]);
    return std::move(elements_);
  }

 private:
  /// In the body's frame; of a model that is there twice, by the first.
  std::optional<Pose> X_BS(const model::Sensor& sensor) const {
    if (draft_.root().format != model::Format::kSdf) return sensor.pose.pose.value;
    const auto index = static_cast<std::uint32_t>(&sensor - draft_.root().sensors.data());
    const auto X_WS = draft_.source.source.frames.pose(model::Id<model::Sensor>{index});
    if (!X_WS) return std::nullopt;
    for (const robot::Body& body : draft_.robot().bodies) {
      if (body.span == body_.span) return compose(inverse(body.X_MB), *X_WS);
    }
    return std::nullopt;
  }

  void add_frames() {
    for (const robot::Frame& frame : draft_.robot().frames) {
      if (frame.body != index_ || frame.of_joint) continue;
      MjcfElement site{"site", {{"name", draft_.name_for("site", frame.name)}}};
      set_placement(site, frame.X_BF);
      elements_.push_back(std::move(site));
    }
  }

  void add_of_joint(const robot::Joint& joint) {
    const model::Joint* written = draft_.entities.joint(joint.span);
    if (written == nullptr) return;
    const auto index = static_cast<std::uint32_t>(written - draft_.root().joints.data());
    for (const model::Sensor& sensor : draft_.root().sensors) {
      if (sensor.joint == model::Id<model::Joint>{index}) add(sensor);
    }
  }

  /// What has no counterpart is lost when the account is closed.
  void add(const model::Sensor& sensor) {
    const auto placed = X_BS(sensor);
    if (!placed) return;
    const std::string& type = sensor.type.value;
    std::string instead;
    if (type == "imu") {
      instead = on_site(sensor, *placed, std::array{"accelerometer", "gyro", "framequat"});
    } else if (type == "force_torque") {
      instead = wrench(sensor, *placed);
    } else if (type == "magnetometer") {
      instead = on_site(sensor, *placed, std::array{"magnetometer"});
    } else if (!sensor.cameras.empty()) {
      instead = camera(sensor, *placed);
    }
    if (instead.empty()) return;
    draft_.ledger.take_all(sensor.site, Outcome::kSubstituted);
    draft_.ledger.note({.kind = NoteKind::kMjcfSensor,
                        .outcome = Outcome::kSubstituted,
                        .where = sensor.site.name,
                        .subject = model::subject(draft_.root(), sensor),
                        .written = type,
                        .instead = std::move(instead)});
  }

  /// Of a body's link, at rest, in the frame of this body.
  std::optional<model::Quaternion> rotation_of(std::uint32_t body) const {
    const model::Link* link = draft_.entities.link(draft_.robot().bodies[body].span);
    if (link == nullptr) return std::nullopt;
    const auto index = static_cast<std::uint32_t>(link - draft_.root().links.data());
    const auto X_WL = draft_.source.source.frames.pose(model::Id<model::Link>{index});
    if (!X_WL) return std::nullopt;
    return compose(inverse(body_.X_MB), *X_WL).rotation;
  }

  /// MuJoCo's is what the parent does to the child (documentation, "sensor/force", and its sign in a simulation), in
  /// the frame of a site of the child.
  std::string wrench(const model::Sensor& sensor, Pose X) {
    const std::string& frame = sensor.wrench.frame.value;
    if (frame != "sensor") {
      const auto& joints = draft_.robot().joints;
      const bool of_parent = frame == "parent" && body_.carrier != robot::kNoIndex;
      const auto rotation = rotation_of(of_parent ? joints[body_.carrier].parent : index_);
      if (rotation) X.rotation = *rotation;
    }
    std::string words = on_site(sensor, X, std::array{"force", "torque"});
    if (frame == "parent") words += " that turns with the child";
    if (sensor.wrench.direction.value == "parent_to_child") return words;
    return words + ", of what the parent does to the child: all signs are reversed";
  }

  template <std::size_t N>
  std::string on_site(const model::Sensor& sensor, const Pose& X,
                      const std::array<const char*, N>& kinds) {
    MjcfElement site{"site", {{"name", draft_.name_for("site", sensor.name.value)}}};
    const std::string name = site.attributes[0].second;
    set_placement(site, X);
    elements_.push_back(std::move(site));
    std::string words;
    for (const char* kind : kinds) {
      MjcfElement element{kind};
      const std::string own = N == 1 ? name : name + "_" + kind;
      element.set("name", draft_.name_for("sensor", own));
      if (std::string_view(kind) == "framequat") {
        element.set("objtype", "site");
        element.set("objname", name);
      } else {
        element.set("site", name);
      }
      draft_.sensor.add(std::move(element));
      words += (words.empty() ? "" : ", ") + std::string(kind);
    }
    return words + " at a site";
  }

  std::string camera(const model::Sensor& sensor, const Pose& X) {
    const model::Camera& given = sensor.cameras.front();
    const double width = given.width.value > 0 ? given.width.value : kWidth;
    const double height = given.height.value > 0 ? given.height.value : kHeight;
    const double half = std::tan(given.horizontal_fov.value / 2) * height / width;
    if (!(half > 0) || !std::isfinite(half)) return {};
    MjcfElement element{"camera", {{"name", draft_.name_for("camera", sensor.name.value)}}};
    set_placement(element, compose(compose(X, given.pose.pose.value), Pose{{}, kLooksAlongX}));
    element.set("fovy", mjcf_number(2 * std::atan(half) * 180 / std::numbers::pi));
    elements_.push_back(std::move(element));
    return "a camera";
  }

  MjcfDraft& draft_;
  std::uint32_t index_;
  const robot::Body& body_;
  std::vector<MjcfElement> elements_;
};

}  // namespace

std::vector<MjcfElement> mjcf_sensors(MjcfDraft& draft, std::uint32_t body) {
  return MjcfSensorMaker(draft, body).make();
}

}  // namespace rigor::convert
