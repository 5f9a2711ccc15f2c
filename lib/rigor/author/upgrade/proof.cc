// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The proof of an upgrade: both files, each read by its own version, number by number. It shares nothing
// with the steps but the readers.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/upgrade/step.h>
#include <rigor/model/frames.h>
#include <rigor/model/motion.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>

namespace rigor::author {
namespace {

using model::Field;
using model::Id;
using model::Root;

/// Upgrades write numbers as they stand, so all but rounding in the last place is a difference: relative
/// to the number, or to 1.
constexpr double kSame = 1e-12;

/// Limits of this size are none, whatever the version writes for it.
constexpr double kUnlimitedFrom = 1e16;

/// Up to this version an effort or velocity of zero is none.
constexpr int kLastWithZeroAsNone = 3;

struct UpgradeSide {
  const read::Loaded& loaded;
  const Root& root;
  model::Frames frames;

  explicit UpgradeSide(const read::Loaded& of) : loaded(of), root(of.root), frames(of.root) {}
  xml::Element element(const model::Site& site) const {
    return loaded.file->document->element(site.element);
  }
};

class UpgradeProof {
 public:
  enum class Direction : std::uint8_t { kUp, kDown };

  UpgradeProof(const read::Loaded& before, const read::Loaded& after, Direction direction)
      : a_(before), b_(after), down_(direction == Direction::kDown) {}

  UpgradeNotes differences() {
    each("world", a_.root.worlds, b_.root.worlds, &UpgradeProof::world);
    each("physics", a_.root.physics, b_.root.physics, &UpgradeProof::physics);
    each("model", a_.root.models, b_.root.models, &UpgradeProof::model);
    each("link", a_.root.links, b_.root.links, &UpgradeProof::link);
    each("joint", a_.root.joints, b_.root.joints, &UpgradeProof::joint);
    if (!has_no(kFirstWithFrames))
      each("frame", a_.root.frames, b_.root.frames, &UpgradeProof::frame);
    each("collision", a_.root.collisions, b_.root.collisions, &UpgradeProof::collision);
    each("visual", a_.root.visuals, b_.root.visuals, &UpgradeProof::visual);
    each("sensor", a_.root.sensors, b_.root.sensors, &UpgradeProof::sensor);
    each("light", a_.root.lights, b_.root.lights, &UpgradeProof::light);
    each("plugin", a_.root.plugins, b_.root.plugins, &UpgradeProof::plugin);
    each("include", a_.root.includes, b_.root.includes, &UpgradeProof::include);
    each("actor", a_.root.actors, b_.root.actors, &UpgradeProof::actor);
    return std::move(notes_);
  }

 private:
  static constexpr int kFirstWithFrames = 7, kFirstWithMimics = 11;

  /// Whether that is a downgrade to a version before this one.
  bool has_no(int first_version) const { return down_ && b_.root.version < first_version; }

  template <class T>
  void each(std::string_view kind, const std::vector<T>& a, const std::vector<T>& b,
            void (UpgradeProof::*compare)(std::uint32_t, const T&, const T&)) {
    if (a.size() != b.size()) {
      where_ = a_.root.site.tag;
      subject_ = "the file";
      differ(fmt::format("number of {}s", kind), std::to_string(a.size()),
             std::to_string(b.size()));
      return;
    }
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      where_ = a_.root.own(a[i].site) ? a[i].site.name : a_.root.site.tag;
      current_ = [&, i] { return model_subject(a_.root, a[i]); };
      (this->*compare)(i, a[i], b[i]);
    }
  }

  template <class T>
  static std::string model_subject(const Root& root, const T& entity) {
    if constexpr (requires { model::subject(root, entity); }) {
      return model::subject(root, entity);
    } else {
      return "the file";
    }
  }

  void differ(std::string_view what, std::string before, std::string after) {
    if (current_) subject_ = current_();
    notes_.add(
        {UpgradeNoteKind::kNotTheSame, Severity::kError, where_,
         fmt::format("{}: {} would be {} instead of {}", subject_, what,
                     after.empty() ? "nothing" : after, before.empty() ? "nothing" : before)});
  }

  // --- Values ---

  static bool is_same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (std::isinf(a) || std::isinf(b)) return a == b;
    return a == b || std::abs(a - b) <= kSame * std::max(1.0, std::abs(a));
  }

  void same(std::string_view what, double a, double b) {
    if (!is_same(a, b)) differ(what, schema::to_shortest(a), schema::to_shortest(b));
  }
  void same(std::string_view what, const Field<double>& a, const Field<double>& b) {
    same(what, a.value, b.value);
  }
  void same(std::string_view what, bool a, bool b) {
    if (a != b) differ(what, a ? "true" : "false", b ? "true" : "false");
  }
  void same(std::string_view what, const Field<bool>& a, const Field<bool>& b) {
    same(what, a.value, b.value);
  }
  void same(std::string_view what, const std::string& a, const std::string& b) {
    if (a != b) differ(what, a, b);
  }
  void same(std::string_view what, const Field<std::string>& a, const Field<std::string>& b) {
    same(what, a.value, b.value);
  }
  void same(std::string_view what, const model::Vector3& a, const model::Vector3& b) {
    if (is_same(a.x, b.x) && is_same(a.y, b.y) && is_same(a.z, b.z)) return;
    differ(what, shown(a), shown(b));
  }
  void same(std::string_view what, const Field<model::Vector3>& a, const Field<model::Vector3>& b) {
    same(what, a.value, b.value);
  }
  void same(std::string_view what, const std::optional<model::Pose>& a,
            const std::optional<model::Pose>& b) {
    if (!a && !b) return;
    if (!a || !b) return differ(what, a ? "known" : "unknown", b ? "known" : "unknown");
    same(what, a->translation, b->translation);
    // q and -q are one rotation.
    const model::Quaternion p = a->rotation;
    const model::Quaternion q = b->rotation;
    const double sign = p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z < 0 ? -1 : 1;
    if (is_same(p.w, sign * q.w) && is_same(p.x, sign * q.x) && is_same(p.y, sign * q.y) &&
        is_same(p.z, sign * q.z)) {
      return;
    }
    differ(what, shown(p), shown(q));
  }
  void same(std::string_view what, const std::optional<model::Vector3>& a,
            const std::optional<model::Vector3>& b) {
    if (!a && !b) return;
    if (!a || !b) return differ(what, a ? "known" : "unknown", b ? "known" : "unknown");
    same(what, *a, *b);
  }

  static std::string shown(const model::Vector3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
  }
  static std::string shown(const model::Quaternion& q) {
    return fmt::format("the rotation {} {} {} {}", q.w, q.x, q.y, q.z);
  }

  template <class T>
  static Id<T> id_of(std::uint32_t index) {
    return Id<T>{index};
  }

  // --- Worlds ---

  void world(std::uint32_t, const model::World& a, const model::World& b) {
    same("name", a.name, b.name);
    same("gravity", a.gravity, b.gravity);
  }

  /// Up to 1.3 each engine has its own.
  double step_size(const UpgradeSide& side, const model::Physics& physics) const {
    constexpr int kLastInEngines = 3;
    if (physics.max_step_size.written || side.root.version > kLastInEngines) {
      return physics.max_step_size.value;
    }
    const xml::Element element = side.element(physics.site);
    const auto ode = element.child("ode");
    const auto solver = ode ? ode->child("solver") : std::nullopt;
    const auto bullet = element.child("bullet");
    const auto of_ode = solver ? read::child_text(*solver, "dt") : std::nullopt;
    const auto of_bullet = bullet ? read::child_text(*bullet, "dt") : std::nullopt;
    const bool first = physics.type.value == "bullet" ? !of_bullet.has_value() : of_ode.has_value();
    return read::number_field(first ? of_ode : of_bullet, physics.max_step_size.value).value;
  }

  void physics(std::uint32_t, const model::Physics& a, const model::Physics& b) {
    same("type", a.type, b.type);
    same("step size", step_size(a_, a), step_size(b_, b));
    same("real time factor", a.real_time_factor, b.real_time_factor);
  }

  // --- Models ---

  void model(std::uint32_t i, const model::Model& a, const model::Model& b) {
    same("name", scoped_name(a_.root, id_of<model::Model>(i)),
         scoped_name(b_.root, id_of<model::Model>(i)));
    same("static", a.is_static, b.is_static);
    same("pose", a_.frames.pose(id_of<model::Model>(i)), b_.frames.pose(id_of<model::Model>(i)));
    if (has_no(kFirstWithFrames)) return;
    same("canonical link", link_name(a_, a_.frames.canonical_link(id_of<model::Model>(i))),
         link_name(b_, b_.frames.canonical_link(id_of<model::Model>(i))));
  }

  static std::string link_name(const UpgradeSide& side, Id<model::Link> id) {
    return id ? scoped_name(side.root, id) : std::string();
  }

  void link(std::uint32_t i, const model::Link& a, const model::Link& b) {
    const Id<model::Link> id{i};
    same("name", scoped_name(a_.root, id), scoped_name(b_.root, id));
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    same("gravity", a.gravity, b.gravity);
    same("kinematic", a.kinematic, b.kinematic);
    const model::Inertial& p = a.inertial;
    const model::Inertial& q = b.inertial;
    same("automatic inertial", p.automatic, q.automatic);
    if (p.automatic.value) same("density", p.density, q.density);
    same("mass", p.mass, q.mass);
    same("center of mass", std::optional(p.pose.pose.value), std::optional(q.pose.pose.value));
    same("frame of the center of mass", p.pose.relative_to, q.pose.relative_to);
    same("ixx", p.ixx, q.ixx);
    same("ixy", p.ixy, q.ixy);
    same("ixz", p.ixz, q.ixz);
    same("iyy", p.iyy, q.iyy);
    same("iyz", p.iyz, q.iyz);
    same("izz", p.izz, q.izz);
  }

  void frame(std::uint32_t i, const model::Frame&, const model::Frame&) {
    const Id<model::Frame> id{i};
    same("name", scoped_name(a_.root, id), scoped_name(b_.root, id));
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    same("link it moves with", link_name(a_, a_.frames.carrier(id)),
         link_name(b_, b_.frames.carrier(id)));
  }

  // --- Joints ---

  /// As a number that is the same for all versions.
  static double limit(double value) {
    if (!(std::abs(value) < kUnlimitedFrom)) {
      return value < 0 ? -std::numeric_limits<double>::infinity()
                       : std::numeric_limits<double>::infinity();
    }
    return value;
  }
  static double most(const Root& root, const model::Joint& joint, const Field<double>& field) {
    const int version = joint.model ? root[joint.model].version : root.version;
    const bool none = !field.written || !(field.value >= 0) ||
                      (field.value == 0 && version <= kLastWithZeroAsNone);
    return none ? std::numeric_limits<double>::infinity() : limit(field.value);
  }

  static std::string end_name(const UpgradeSide& side, Id<model::Link> id, bool is_world) {
    return is_world ? "world" : link_name(side, id);
  }

  void joint(std::uint32_t i, const model::Joint& a, const model::Joint& b) {
    const Id<model::Joint> id{i};
    same("name", scoped_name(a_.root, id), scoped_name(b_.root, id));
    same("type", a.type_name, b.type_name);
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    const model::Frames::Ends& p = a_.frames.ends(id);
    const model::Frames::Ends& q = b_.frames.ends(id);
    same("parent", end_name(a_, p.parent, p.parent_is_world),
         end_name(b_, q.parent, q.parent_is_world));
    same("child", end_name(a_, p.child, false), end_name(b_, q.child, false));
    if (down_ && a.type == model::JointType::kScrew) {
      same("lead", model::screw_lead(a_.root, a), model::screw_lead(b_.root, b));
    } else if (!down_) {
      same("thread pitch", a.thread_pitch, b.thread_pitch);
    }
    if (!down_ && a.type == model::JointType::kScrew &&
        a.thread_pitch.written != b.thread_pitch.written && b_.root.version < 10) {
      same("written thread pitch", a.thread_pitch.written, b.thread_pitch.written);
    }
    same("gearbox ratio", a.gearbox_ratio, b.gearbox_ratio);
    if (a.axes.size() != b.axes.size()) {
      return differ("number of axes", std::to_string(a.axes.size()), std::to_string(b.axes.size()));
    }
    for (std::size_t k = 0; k < a.axes.size(); ++k) {
      if (k < 2) same("axis", a_.frames.axis(id, k), b_.frames.axis(id, k));
      axis(a, b, a.axes[k], b.axes[k]);
    }
  }

  void axis(const model::Joint& joint_a, const model::Joint& joint_b, const model::Axis& a,
            const model::Axis& b) {
    same("length of the axis", length(a.xyz.value), length(b.xyz.value));
    same("lower limit", limit(a.lower.value), limit(b.lower.value));
    same("upper limit", limit(a.upper.value), limit(b.upper.value));
    same("effort", most(a_.root, joint_a, a.effort), most(b_.root, joint_b, b.effort));
    same("velocity", most(a_.root, joint_a, a.velocity), most(b_.root, joint_b, b.velocity));
    same("damping", a.damping, b.damping);
    same("friction", a.friction, b.friction);
    same("spring reference", a.spring_reference, b.spring_reference);
    same("spring stiffness", a.spring_stiffness, b.spring_stiffness);
    if (has_no(kFirstWithMimics)) return;
    same("mimic", a.mimic.has_value(), b.mimic.has_value());
    if (!a.mimic || !b.mimic) return;
    same("joint that is mimicked", a.mimic->joint, b.mimic->joint);
    same("axis that is mimicked", a.mimic->axis, b.mimic->axis);
    same("multiplier", a.mimic->multiplier, b.mimic->multiplier);
    same("offset", a.mimic->offset, b.mimic->offset);
    same("reference", a.mimic->reference, b.mimic->reference);
  }

  // --- What links hold ---

  void collision(std::uint32_t i, const model::Collision& a, const model::Collision& b) {
    const Id<model::Collision> id{i};
    same("name", scoped_name(a_.root, id), scoped_name(b_.root, id));
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    geometry(a.geometry, b.geometry);
    // What no version up to 1.10 reads counts from 1.11 on, where an inertial is automatic.
    if (a_.root[a.link].inertial.automatic.value) {
      same("density", a.density.written, b.density.written);
    }
    same("mu", a.surface.mu, b.surface.mu);
    same("mu2", a.surface.mu2, b.surface.mu2);
    same("slip1", a.surface.slip1, b.surface.slip1);
    same("slip2", a.surface.slip2, b.surface.slip2);
    same("kp", a.surface.kp, b.surface.kp);
    same("kd", a.surface.kd, b.surface.kd);
  }

  void visual(std::uint32_t i, const model::Visual& a, const model::Visual& b) {
    const Id<model::Visual> id{i};
    same("name", scoped_name(a_.root, id), scoped_name(b_.root, id));
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    geometry(a.geometry, b.geometry);
    same("colors", a.material.defines_color, b.material.defines_color);
    // In 1.0 the name of a script is an attribute that the reader leaves aside.
    if (a_.root.version > 0) same("material", a.material.name, b.material.name);
  }

  void geometry(const model::Geometry& a, const model::Geometry& b) {
    if (down_ && std::holds_alternative<model::NoShape>(b.shape)) return;
    if (a.shape.index() != b.shape.index()) {
      return differ("shape", std::string(shape_name(a.shape)), std::string(shape_name(b.shape)));
    }
    std::visit(
        [&](const auto& shape) { shapes(shape, std::get<std::decay_t<decltype(shape)>>(b.shape)); },
        a.shape);
  }
  void shapes(const model::NoShape&, const model::NoShape&) {}
  void shapes(const model::Box& a, const model::Box& b) { same("size", a.size, b.size); }
  void shapes(const model::Sphere& a, const model::Sphere& b) {
    same("radius", a.radius, b.radius);
  }
  template <class Round>
  void shapes(const Round& a, const Round& b) {  // cylinder, capsule, cone
    same("radius", a.radius, b.radius);
    same("length", a.length, b.length);
  }
  void shapes(const model::Ellipsoid& a, const model::Ellipsoid& b) {
    same("radii", a.radii, b.radii);
  }
  void shapes(const model::Plane& a, const model::Plane& b) { same("normal", a.normal, b.normal); }
  void shapes(const model::Mesh& a, const model::Mesh& b) {
    same("URI", a.uri, b.uri);
    same("scale", a.scale, b.scale);
    same("submesh", a.submesh, b.submesh);
    same("centered submesh", a.center, b.center);
  }
  void shapes(const model::Heightmap& a, const model::Heightmap& b) {
    same("URI", a.uri, b.uri);
    same("size", a.size, b.size);
  }
  void shapes(const model::Image& a, const model::Image& b) { same("URI", a.uri, b.uri); }
  void shapes(const model::Polyline& a, const model::Polyline& b) {
    same("height", a.height, b.height);
    same("number of points", static_cast<double>(a.points.size()),
         static_cast<double>(b.points.size()));
    for (std::size_t i = 0; i < std::min(a.points.size(), b.points.size()); ++i) {
      same("point", a.points[i], b.points[i]);
    }
  }

  void sensor(std::uint32_t i, const model::Sensor& a, const model::Sensor& b) {
    const Id<model::Sensor> id{i};
    same("name", a.name, b.name);
    same("type", a.type, b.type);
    same("pose", a_.frames.pose(id), b_.frames.pose(id));
    same("update rate", a.update_rate, b.update_rate);
    same("topic", a.topic, b.topic);
    same("number of cameras", static_cast<double>(a.cameras.size()),
         static_cast<double>(b.cameras.size()));
    for (std::size_t k = 0; k < std::min(a.cameras.size(), b.cameras.size()); ++k) {
      same("near", a.cameras[k].near_clip, b.cameras[k].near_clip);
      same("far", a.cameras[k].far_clip, b.cameras[k].far_clip);
      same("width", a.cameras[k].width, b.cameras[k].width);
      same("height", a.cameras[k].height, b.cameras[k].height);
      // In 1.0 it is the attribute `angle`, which the reader leaves aside.
      if (a_.root.version > 0) {
        same("field of view", a.cameras[k].horizontal_fov, b.cameras[k].horizontal_fov);
      }
    }
    same("scanner", a.lidar.has_value(), b.lidar.has_value());
    if (!a.lidar || !b.lidar) return;
    same("range", a.lidar->range_min, b.lidar->range_min);
    same("range", a.lidar->range_max, b.lidar->range_max);
    same("samples", a.lidar->horizontal.samples, b.lidar->horizontal.samples);
    same("angle", a.lidar->horizontal.min_angle, b.lidar->horizontal.min_angle);
    same("angle", a.lidar->horizontal.max_angle, b.lidar->horizontal.max_angle);
  }

  void light(std::uint32_t i, const model::Light& a, const model::Light& b) {
    same("name", a.name, b.name);
    same("type", a.type, b.type);
    same("pose", a_.frames.pose(id_of<model::Light>(i)), b_.frames.pose(id_of<model::Light>(i)));
  }

  void actor(std::uint32_t, const model::Actor& a, const model::Actor& b) {
    same("name", a.name, b.name);
  }

  void plugin(std::uint32_t, const model::Plugin& a, const model::Plugin& b) {
    same("name", a.name, b.name);
    same("file name", a.filename, b.filename);
    if (!a_.root.own(a.site) || !b_.root.own(b.site)) return;
    if (bytes(a_, a.site.span) != bytes(b_, b.site.span)) differ("content", "as it is", "another");
  }
  static std::string_view bytes(const UpgradeSide& side, Span span) {
    return side.loaded.file->document->bytes().substr(span.begin, span.size());
  }

  void include(std::uint32_t, const model::Include& a, const model::Include& b) {
    same("URI", a.uri, b.uri);
    same("name", a.name, b.name);
    same("static", a.is_static, b.is_static);
    same("merge", a.merge, b.merge);
    same("placement frame", a.placement_frame, b.placement_frame);
    same("file", a.path, b.path);
  }

  UpgradeSide a_;
  UpgradeSide b_;
  bool down_;
  Span where_;
  std::string subject_;
  std::function<std::string()> current_;
  UpgradeNotes notes_;
};

}  // namespace

UpgradeNotes differences_after_upgrade(const read::Loaded& before, const read::Loaded& after) {
  return UpgradeProof(before, after, UpgradeProof::Direction::kUp).differences();
}

UpgradeNotes differences_after_downgrade(const read::Loaded& before, const read::Loaded& after) {
  return UpgradeProof(before, after, UpgradeProof::Direction::kDown).differences();
}

}  // namespace rigor::author
