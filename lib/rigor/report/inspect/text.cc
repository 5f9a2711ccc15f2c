// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/mass/resolve.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

using model::Id;

constexpr int kTextDigits = 6;

std::string quoted_name(std::string_view name) { return '"' + printable(name) + '"'; }

std::string_view mark(bool written) { return written ? "" : " (default)"; }

std::string pose_text(const std::optional<model::Pose>& pose) {
  if (!pose) return "unknown: a frame cannot be resolved";
  return fmt::format("{} m, rpy {} rad", numbers(pose->translation, kTextDigits),
                     numbers(to_rpy(pose->rotation), kTextDigits));
}

struct ShapeText {
  std::string operator()(const model::Box& s) const {
    return numbers(s.size.value, kTextDigits) + " m";
  }
  std::string operator()(const model::Sphere& s) const { return radius(s.radius.value); }
  std::string operator()(const model::Cylinder& s) const { return round(s); }
  std::string operator()(const model::Capsule& s) const { return round(s); }
  std::string operator()(const model::Cone& s) const { return round(s); }
  std::string operator()(const model::Ellipsoid& s) const {
    return "radii " + numbers(s.radii.value, kTextDigits) + " m";
  }
  std::string operator()(const model::Plane& s) const {
    return "normal " + numbers(s.normal.value, kTextDigits);
  }
  std::string operator()(const model::Mesh& s) const {
    const std::string text = quoted_name(s.uri.value);
    return s.scale.written ? text + " scale " + numbers(s.scale.value, kTextDigits) : text;
  }
  std::string operator()(const model::Heightmap& s) const { return quoted_name(s.uri.value); }
  std::string operator()(const model::Image& s) const { return quoted_name(s.uri.value); }
  std::string operator()(const model::Polyline& s) const {
    return fmt::format("{} high {} m", counted(s.points.size(), "point"), number(s.height.value));
  }
  std::string operator()(const model::NoShape&) const { return {}; }

  static std::string radius(double value) { return "radius " + number(value) + " m"; }
  static std::string round(const auto& s) {
    return radius(s.radius.value) + ", length " + number(s.length.value) + " m";
  }
};

class Tree {
 public:
  explicit Tree(const Inspection& inspection) : inspection_(inspection), root_(inspection.root) {}

  std::string all() {
    out_ = printable(inspection_.path) + ": " + format() + '\n';
    for (const model::World& world : root_.worlds) {
      out_ += fmt::format("\nworld {}: {}\n", quoted_name(world.name.value),
                          counted(world.models.size(), "model"));
    }
    for (const Id<model::Model> top : top_models(root_)) {
      out_ += '\n';
      model(top, 0);
      sum(top);
    }
    return std::move(out_);
  }

 private:
  std::string format() const {
    switch (root_.format) {
      case model::Format::kSdf: return "SDF " + printable(root_.version_text.value);
      case model::Format::kUrdf: return "URDF";
      case model::Format::kModelConfig: return "model.config";
      case model::Format::kMjcf: return "MJCF";
      case model::Format::kUnknown: break;
    }
    return "unknown format";
  }

  void line(int depth, std::string_view text) {
    out_ += std::string(static_cast<std::size_t>(2 * depth), ' ');
    out_ += text;
    out_ += '\n';
  }

  template <class T>
  void entity(int depth, std::string_view kind, Id<T> id, std::string_view more = {}) {
    line(depth, fmt::format("{} {}{}", kind, quoted_name(root_[id].name.value), more));
    line(depth + 1, fmt::format("pose {}{}", pose_text(inspection_.frames.pose(id)),
                                mark(root_[id].pose.pose.written)));
  }

  void model(Id<model::Model> id, int depth) {
    const model::Model& model = root_[id];
    entity(depth, "model", id, model.is_static.value ? ", static" : "");
    for (const Id<model::Link> child : model.links) link(child, depth + 1);
    for (const Id<model::Frame> child : model.frames) entity(depth + 1, "frame", child);
    for (const Id<model::Joint> child : model.joints) joint(child, depth + 1);
    for (const Id<model::Model> child : model.models) this->model(child, depth + 1);
  }

  void link(Id<model::Link> id, int depth) {
    entity(depth, "link", id);
    inertial(id, depth + 1);
    for (const Id<model::Collision> child : root_[id].collisions) {
      entity(depth + 1, "collision", child, shape(root_[child].geometry));
    }
    for (const Id<model::Visual> child : root_[id].visuals) {
      entity(depth + 1, "visual", child, shape(root_[child].geometry));
    }
  }

  void inertial(Id<model::Link> id, int depth) {
    const model::Inertial& written = root_[id].inertial;
    const auto [body, taken] = inspection_.inertial(id);
    const mass::Inertia& i = body.about_com;
    const bool computed = taken == mass::Taken::kAutomatic;
    if (computed) line(depth, "inertial computed from the collisions");
    if (taken == mass::Taken::kAutomaticUnknown) {
      line(depth, "inertial is automatic, but a collision is not a solid");
    }
    line(depth, fmt::format("mass {} kg{}, center of mass {} m{}", number(body.mass),
                            mark(computed || written.mass.written), numbers(body.com, kTextDigits),
                            mark(computed || written.pose.pose.written)));
    line(depth,
         fmt::format("inertia ixx {} iyy {} izz {} ixy {} ixz {} iyz {} kg·m²{}", number(i.ixx),
                     number(i.iyy), number(i.izz), number(i.ixy), number(i.ixz), number(i.iyz),
                     mark(computed || written.tensor_written)));
  }

  static std::string shape(const model::Geometry& geometry) {
    const std::string size = std::visit(ShapeText{}, geometry.shape);
    return fmt::format(": {}{}{}", shape_name(geometry.shape), size.empty() ? "" : " ", size);
  }

  void joint(Id<model::Joint> id, int depth) {
    const model::Joint& joint = root_[id];
    const auto end = [](const std::optional<std::string>& name) {
      return name ? quoted_name(*name) : "nothing";
    };
    entity(depth, "joint", id,
           fmt::format(": {} from {} to {}", to_string(joint.type),
                       end(parent_name(inspection_, id)), end(child_name(inspection_, id))));
    for (std::size_t i = 0; i < joint.axes.size(); ++i) axis(id, i, depth + 1);
  }

  void axis(Id<model::Joint> id, std::size_t index, int depth) {
    const model::Axis& axis = root_[id].axes[index];
    const bool prismatic = root_[id].type == model::JointType::kPrismatic;
    const std::optional<model::Vector3> direction = inspection_.frames.axis(id, index);
    line(depth, fmt::format("{} {}{}", index == 0 ? "axis" : "axis2",
                            direction ? numbers(*direction, kTextDigits) : "unknown",
                            mark(axis.xyz.written)));
    line(depth + 1,
         fmt::format("limits {}{} to {}{} {}", number(axis.lower.value), mark(axis.lower.written),
                     number(axis.upper.value), mark(axis.upper.written), prismatic ? "m" : "rad"));
    line(depth + 1, fmt::format("effort {} {}{}, velocity {} {}{}", number(axis.effort.value),
                                prismatic ? "N" : "N·m", mark(axis.effort.written),
                                number(axis.velocity.value), prismatic ? "m/s" : "rad/s",
                                mark(axis.velocity.written)));
    if (axis.mimic) line(depth + 1, "mimics " + quoted_name(axis.mimic->joint.value));
  }

  void sum(Id<model::Model> top) {
    const Totals all = totals(inspection_, top);
    line(1,
         fmt::format("total: {}, {}, {} kg{}", counted(all.links, "link"),
                     counted(all.joints, "joint"), number(all.mass),
                     all.com ? ", center of mass " + numbers(*all.com, kTextDigits) + " m" : ""));
  }

  const Inspection& inspection_;
  const model::Root& root_;
  std::string out_;
};

}  // namespace

std::string inspect_text(const Inspection& inspection) { return Tree(inspection).all(); }

}  // namespace rigor::report
