// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/resolve.h>
#include <rigor/report/inspect.h>
#include <rigor/report/number.h>

namespace rigor::report {
namespace {

using model::Id;

constexpr int kTsvDigits = 12;

/// A name as one word.
std::string word(std::string_view name) {
  std::string out;
  for (const char c : name) {
    switch (c) {
      case ' ': out += "\\s"; break;
      case '\t': out += "\\t"; break;
      case '\n': out += "\\n"; break;
      case '\r': out += "\\r"; break;
      case '\\': out += "\\\\"; break;
      default: out += c;
    }
  }
  return out;
}

std::string pose_columns(const model::Pose& pose) {
  const model::Vector3& p = pose.translation;
  const model::Quaternion q = positive_w(pose.rotation);
  std::string out;
  for (const double value : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) {
    out += number(value, kTsvDigits) + '\t';
  }
  return out;
}

class Rows {
 public:
  explicit Rows(const Inspection& inspection) : inspection_(inspection), root_(inspection.root) {}

  std::string all() {
    for (const Id<model::Model> top : top_models(root_)) model(top);
    for (const model::World& world : root_.worlds) {
      for (const Id<model::Frame> frame : world.frames) row("frame", frame, {});
      for (const Id<model::Joint> joint : world.joints) row("joint", joint, joint_extra(joint));
    }
    return std::move(out_);
  }

 private:
  template <class T>
  void row(std::string_view kind, Id<T> id, const std::string& extra) {
    const std::optional<model::Pose> pose = inspection_.frames.pose(id);
    if (!pose) return;
    out_ += kind;
    out_ += '\t' + word(scoped_name(root_, id)) + '\t' + pose_columns(*pose) + extra + '\n';
  }

  void model(Id<model::Model> id) {
    row("model", id, {});
    const model::Model& model = root_[id];
    for (const Id<model::Link> link : model.links) {
      row("link", link, link_extra(link));
      for (const auto collision : root_[link].collisions) row("collision", collision, {});
      for (const auto visual : root_[link].visuals) row("visual", visual, {});
    }
    for (const Id<model::Frame> frame : model.frames) row("frame", frame, {});
    for (const Id<model::Joint> joint : model.joints) row("joint", joint, joint_extra(joint));
    for (const Id<model::Model> nested : model.models) this->model(nested);
  }

  std::string link_extra(Id<model::Link> link) const {
    const mass::MassProperties body = inspection_.inertial(link).body;
    const mass::Inertia& i = body.about_com;
    std::string out = number(body.mass, kTsvDigits) + ' ' + numbers(body.com, kTsvDigits);
    for (const double value : {i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz}) {
      out += ' ' + number(value, kTsvDigits);
    }
    return out;
  }

  std::string joint_extra(Id<model::Joint> id) const {
    const auto named = [](const std::optional<std::string>& name) {
      return name ? word(*name) : "-";
    };
    std::string out =
        named(parent_name(inspection_, id)) + ' ' + named(child_name(inspection_, id)) + ' ';
    out += to_string(root_[id].type);
    for (std::size_t i = 0; i < root_[id].axes.size(); ++i) {
      const std::optional<model::Vector3> axis = inspection_.frames.axis(id, i);
      out += ' ' + (axis ? numbers(*axis, kTsvDigits) : "nan nan nan");
    }
    return out;
  }

  const Inspection& inspection_;
  const model::Root& root_;
  std::string out_;
};

}  // namespace

std::string inspect_tsv(const Inspection& inspection) { return Rows(inspection).all(); }

}  // namespace rigor::report
