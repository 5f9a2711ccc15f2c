// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/scale.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/author/names/parameter_lengths.h>
#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/motion.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Vector3;

/// How the numbers of an axis grow: by the power of the factor.
struct AxisPowers {
  double position, effort, velocity, damping, stiffness;
};
constexpr AxisPowers kTurningPowers{0, 4, -0.5, 4.5, 4};
constexpr AxisPowers kSlidingPowers{1, 3, 0.5, 2.5, 2};

/// The largest, of moments of inertia.
constexpr double kMaxPower = 5;

constexpr double kContactStiffnessPower = 2;
constexpr double kContactDampingPower = 2.5;

/// What people write of parameters; what is larger is data.
constexpr std::uint64_t kMaxListedBytes = std::uint64_t{1} << 20U;

double kept_if_endless(double value, double factor) {
  return std::isfinite(value) ? value * factor : value;
}

/// The law.
class ScaledRobot {
 public:
  /// The bodies of the set have the mass that a consumer takes where it knows none.
  ScaledRobot(robot::Robot robot, double factor, std::set<std::string> unknown)
      : robot_(std::move(robot)), f_(factor), unknown_(std::move(unknown)) {}

  robot::Robot scale() && {
    for (robot::Body& body : robot_.bodies) {
      scale(body.X_MB);
      body.mass = unknown_.contains(body.name) ? with_center(body.mass)
                                               : mass::scaled_at_density(f_, body.mass);
      for (auto* parts : {&body.collisions, &body.visuals}) {
        for (robot::Part& part : *parts) {
          scale(part.X_BS);
          if (part.shape.kind == "plane") continue;
          for (double& number : part.shape.numbers) number *= f_;
        }
      }
    }
    for (robot::Frame& frame : robot_.frames) scale(frame.X_BF);
    const robot::Robot before = robot_;
    for (robot::Joint& joint : robot_.joints) {
      scale(joint.X_PJ);
      scale(joint.X_CJ);
      for (robot::Axis& axis : joint.axes) scale(axis, before);
    }
    robot::connect(robot_);
    return std::move(robot_);
  }

 private:
  mass::MassProperties with_center(mass::MassProperties body) const {
    body.com = f_ * body.com;
    return body;
  }
  void scale(model::Pose& X) const { X.translation = f_ * X.translation; }

  static bool slides(const robot::Axis& axis) { return axis.motion == robot::Axis::Motion::kSlide; }

  void scale(robot::Axis& axis, const robot::Robot& before) const {
    const AxisPowers& power = slides(axis) ? kSlidingPowers : kTurningPowers;
    const auto grow = [this](double& value, double by) {
      value = kept_if_endless(value, std::pow(f_, by));
    };
    grow(axis.lower, power.position);
    grow(axis.upper, power.position);
    grow(axis.effort, power.effort);
    grow(axis.friction, power.effort);
    grow(axis.velocity, power.velocity);
    grow(axis.damping, power.damping);
    grow(axis.spring_reference, power.position);
    grow(axis.spring_stiffness, power.stiffness);
    grow(axis.slide, 1);
    if (!axis.follow) return;
    grow(axis.follow->offset, power.position);
    for (const robot::Joint& leader : before.joints) {
      if (leader.name != axis.follow->joint || axis.follow->axis >= leader.axes.size()) continue;
      const double by = (slides(axis) ? 1 : 0) - (slides(leader.axes[axis.follow->axis]) ? 1 : 0);
      grow(axis.follow->multiplier, by);
    }
  }

  robot::Robot robot_;
  double f_;
  std::set<std::string> unknown_;
};

class Scaler {
 public:
  Scaler(const EditedModel& edited, double factor, const ReferringFiles& files)
      : edited_(edited), root_(edited.root()), files_(files), draft_(edited), f_(factor) {}

  Change scale() {
    for (const Placed& each : placed_in(edited_)) {
      model::Pose X = each.field.pose.value;
      X.translation = {grown(X.translation.x, 1), grown(X.translation.y, 1),
                       grown(X.translation.z, 1)};
      draft_.set_pose(each.field, each.holder, X);
    }
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (edited_.inside(root_.links[i].model)) scale_inertial(root_.links[i], Id<model::Link>{i});
    }
    for (const model::Collision& each : root_.collisions) {
      if (!each.link || !edited_.inside(root_[each.link].model)) continue;
      scale_shape(each.geometry);
      grow(each.surface.kp, kContactStiffnessPower);
      grow(each.surface.kd, kContactDampingPower);
      grow(each.surface.min_depth, 1);
    }
    for (const model::Visual& each : root_.visuals) {
      if (each.link && edited_.inside(root_[each.link].model)) scale_shape(each.geometry);
    }
    for (const model::Joint& joint : root_.joints) {
      if (edited_.inside(joint.model)) scale_joint(joint);
    }
    list_lengths();
    for (const std::string& path : files_.all()) list_lengths(path);
    Change change;
    change.refused = fault_.empty() ? draft_.problem() : fault_;
    change.steps = draft_.take();
    change.notes = std::move(notes_);
    change.expected = ScaledRobot(edited_.robot, f_, unknown_masses()).scale();
    change.asks_for_setting = [](const robot::Difference& difference) {
      const std::string_view what = difference.what;
      return is_of_pose(difference) || what.ends_with("kp") || what.ends_with("kd") ||
             what.ends_with("min_depth") || what.ends_with("minDepth");
    };
    return change;
  }

 private:
  std::set<std::string> unknown_masses() const {
    std::set<std::string> unknown;
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const Id<model::Link> id{i};
      if (!edited_.inside(root_[id].model)) continue;
      if (mass::resolve(root_, edited_.frames, id, edited_.find_mesh).taken ==
          mass::Taken::kAutomaticUnknown)
        unknown.insert(edited_.name_of(id));
    }
    return unknown;
  }

  double grown(double value, double power) {
    const double result = value * std::pow(f_, power);
    const bool is_lost = !std::isfinite(result) || (result == 0) != (value == 0);
    if (std::isfinite(value) && is_lost)
      fault_ = fmt::format("{} scaled by {:g} is out of the range of numbers", value, f_);
    return write::settled(result, value, std::abs(result));
  }

  void grow(const model::Field<double>& field, double power) {
    if (power != 0) draft_.set(field, grown(field.value, power));
  }
  void grow(const model::Field<Vector3>& field) {
    const Vector3& v = field.value;
    draft_.set(field, {grown(v.x, 1), grown(v.y, 1), grown(v.z, 1)});
  }

  /// What SDF takes where nothing is written is 1 kg and the identity, whatever the size.
  void scale_inertial(const model::Link& link, Id<model::Link>) {
    const model::Inertial& inertial = link.inertial;
    grow(inertial.mass, 3);
    const std::pair<const char*, const model::Field<double>*> entries[] = {
        {"ixx", &inertial.ixx}, {"ixy", &inertial.ixy}, {"ixz", &inertial.ixz},
        {"iyy", &inertial.iyy}, {"iyz", &inertial.iyz}, {"izz", &inertial.izz}};
    for (const auto& [name, entry] : entries) grow(*entry, 5);
    if (edited_.is_urdf() || inertial.automatic.value) return;
    std::string tensor;
    for (const auto& [name, entry] : entries) {
      if (entry->written || entry->value == 0) continue;
      tensor += fmt::format("\n  <{0}>{1}</{0}>", name, text(entry->value, 5));
    }
    std::string missing;
    if (!inertial.mass.written) missing = "<mass>" + text(inertial.mass.value, 3) + "</mass>";
    if (!inertial.tensor_written) {
      if (!missing.empty()) missing += '\n';
      missing += "<inertia>" + tensor + "\n</inertia>";
    } else if (!tensor.empty()) {
      draft_.insert(edited_.element(inertial.tensor_site), last_child(inertial.tensor_site),
                    tensor.substr(1));
    }
    if (missing.empty()) return;
    if (inertial.written) {
      draft_.insert(edited_.element(inertial.site), last_child(inertial.site), missing);
      return;
    }
    std::string lines = missing;
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 3)
      lines.insert(at + 1, "  ");
    draft_.insert(edited_.element(link.site), last_child(link.site),
                  "<inertial>\n  " + lines + "\n</inertial>");
  }

  std::optional<xml::Element> last_child(const model::Site& site) const {
    return last_child_of(edited_.element(site));
  }

  std::string text(double value, double power) { return schema::to_shortest(grown(value, power)); }

  /// Of SDF: what is not written has a size all the same.
  void add_defaults(const model::Geometry& geometry,
                    const std::vector<std::pair<std::string, std::string>>& sizes) {
    if (edited_.is_urdf() || sizes.empty()) return;
    std::string xml;
    for (const auto& [name, value] : sizes)
      xml += (xml.empty() ? "" : "\n") + fmt::format("<{0}>{1}</{0}>", name, value);
    draft_.insert(edited_.element(geometry.site), last_child(geometry.site), xml);
  }

  void scale_shape(const model::Geometry& geometry) {
    std::visit([&](const auto& shape) { scale(geometry, shape); }, geometry.shape);
  }
  void scale(const model::Geometry&, const model::NoShape&) {}
  void scale(const model::Geometry& geometry, const model::Box& shape) {
    grow(shape.size);
    const Vector3& size = shape.size.value;
    if (!shape.size.written)
      add_defaults(geometry,
                   {{"size", text(size.x, 1) + ' ' + text(size.y, 1) + ' ' + text(size.z, 1)}});
  }
  void scale(const model::Geometry& geometry, const model::Sphere& shape) {
    grow(shape.radius, 1);
    if (!shape.radius.written) add_defaults(geometry, {{"radius", text(shape.radius.value, 1)}});
  }
  template <class Round>
  void scale(const model::Geometry& geometry, const Round& shape) {  // cylinder, capsule, cone
    grow(shape.radius, 1);
    grow(shape.length, 1);
    std::vector<std::pair<std::string, std::string>> missing;
    if (!shape.radius.written) missing.emplace_back("radius", text(shape.radius.value, 1));
    if (!shape.length.written) missing.emplace_back("length", text(shape.length.value, 1));
    add_defaults(geometry, missing);
  }
  void scale(const model::Geometry&, const model::Ellipsoid& shape) { grow(shape.radii); }
  void scale(const model::Geometry&, const model::Plane&) {}
  void scale(const model::Geometry& geometry, const model::Mesh& shape) {
    if (shape.scale.written) return grow(shape.scale);
    const std::string factor = text(1, 1);
    const std::string factors = factor + ' ' + factor + ' ' + factor;
    const xml::Element mesh = edited_.element(geometry.site);
    if (edited_.is_urdf()) {
      draft_.set_attribute(mesh, "scale", factors);
    } else {
      draft_.insert(mesh, last_child(geometry.site), "<scale>" + factors + "</scale>");
    }
  }
  void scale(const model::Geometry&, const model::Heightmap& shape) { grow(shape.size); }
  void scale(const model::Geometry&, const model::Image&) {}
  void scale(const model::Geometry&, const model::Polyline& shape) {
    for (const auto& point : shape.points) {
      draft_.set_first_numbers(point, {grown(point.value.x, 1), grown(point.value.y, 1)});
    }
    grow(shape.height, 1);
  }

  void scale_joint(const model::Joint& joint) {
    const bool slides = joint.type == model::JointType::kPrismatic;
    const AxisPowers& power = slides ? kSlidingPowers : kTurningPowers;
    const auto grow_bound = [&](const model::Field<double>& bound, double by) {
      if (std::isfinite(bound.value) && std::abs(bound.value) < model::kUnlimited) grow(bound, by);
    };
    grow(joint.screw_thread_pitch, 1);
    grow(joint.thread_pitch, -1);
    for (const model::Axis& axis : joint.axes) {
      grow_bound(axis.lower, power.position);
      grow_bound(axis.upper, power.position);
      if (axis.effort.value > 0) grow_bound(axis.effort, power.effort);
      if (axis.velocity.value > 0) grow_bound(axis.velocity, power.velocity);
      grow(axis.damping, power.damping);
      grow(axis.friction, power.effort);
      grow(axis.spring_reference, power.position);
      grow(axis.spring_stiffness, power.stiffness);
      if (axis.mimic) scale_mimic(joint, slides, *axis.mimic);
    }
    if (joint.safety && slides) {
      grow(joint.safety->soft_lower, 1);
      grow(joint.safety->soft_upper, 1);
    }
  }

  void scale_mimic(const model::Joint& joint, bool slides, const model::Mimic& mimic) {
    const auto leader = edited_.frames.names().find_joint(joint.model, mimic.joint.value);
    const bool leader_slides = leader && root_[leader].type == model::JointType::kPrismatic;
    grow(mimic.offset, slides ? 1 : 0);
    grow(mimic.reference, leader_slides ? 1 : 0);
    grow(mimic.multiplier, (slides ? 1 : 0) - (leader_slides ? 1 : 0));
  }

  void list_lengths() {
    for (const model::Plugin& plugin : root_.plugins) {
      if (root_.own(plugin.site)) list_lengths(plugin.parameters);
    }
  }
  void list_lengths(const model::Parameters& parameters) {
    for (const model::Parameter& each : parameters) {
      if (is_length_name(each.name) && each.children.empty() && write::number_in(each.value.value))
        note_length(each.site.span, fmt::format("<{}>{}", each.name, each.value.value));
      list_lengths(each.children);
    }
  }

  /// Of a file of parameters that was named, or names a joint of the robot.
  void list_lengths(const std::string& path) {
    const auto format = parameter_format(path);
    const ReadResult read =
        format ? edited_.environment.disk.read(path, kMaxListedBytes) : ReadResult{};
    if (!read.bytes) return;
    const std::string_view bytes = *read.bytes;
    const bool is_named =
        std::find(files_.named.begin(), files_.named.end(), path) != files_.named.end();
    const auto names_joint = [&](const robot::Joint& joint) {
      const auto uses = parameter_names(bytes, *format, kNoSource, joint.name);
      return std::any_of(uses.begin(), uses.end(),
                         [](const ParameterName& use) { return use.is_of({NameKind::kJoint}); });
    };
    const std::vector<robot::Joint>& joints = edited_.robot.joints;
    if (!is_named && std::none_of(joints.begin(), joints.end(), names_joint)) return;
    const SourceId source = edited_.sources.add(path, *read.bytes);
    for (const ParameterText& length : parameter_lengths(bytes, *format, source)) {
      note_length(length.where,
                  fmt::format("{}: {}", length.keys.back(), edited_.sources.bytes(length.where)));
    }
  }

  void note_length(Span where, const std::string& what) {
    notes_.push_back(fmt::format("{}:{}: may be a length, kept: {}",
                                 edited_.sources.path(where.source),
                                 edited_.sources.position(where.source, where.begin).line, what));
  }

  const EditedModel& edited_;
  const model::Root& root_;
  const ReferringFiles& files_;
  Draft draft_;
  double f_;
  std::string fault_;
  std::vector<std::string> notes_;
};

}  // namespace

Change scaled(const EditedModel& edited, double factor, const ReferringFiles& files) {
  if (!(factor > 0) || !std::isfinite(factor)) return refusal("a factor is positive");
  if (!std::isnormal(std::pow(factor, kMaxPower))) {
    return refusal(fmt::format(
        "with a factor of {:g} moments of inertia are out of the range of numbers", factor));
  }
  if (const auto included = included_part(edited))
    return refusal("a part of it is in " + *included + ": scale that first");
  return Scaler(edited, factor, files).scale();
}

}  // namespace rigor::author
