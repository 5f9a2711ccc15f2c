// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/convert/xml_writer.h>

namespace rigor::convert {
namespace {

/// In the order in which a hand would write the tree: a link, the joint that carries it, and then
/// what hangs on that link; joints in their own order.
class UrdfTreeOrder {
 public:
  explicit UrdfTreeOrder(const UrdfRobot& robot) : robot_(robot), visited_(robot.links.size()) {
    std::unordered_map<std::string_view, std::size_t> links;
    for (std::size_t i = 0; i < robot.links.size(); ++i) links.try_emplace(robot.links[i].name, i);
    carriers_.resize(robot.links.size(), kNone);
    children_.resize(robot.links.size());
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const auto child = links.find(robot.joints[i].child);
      const auto parent = links.find(robot.joints[i].parent);
      if (child == links.end() || parent == links.end()) continue;
      if (carriers_[child->second] != kNone) continue;
      carriers_[child->second] = i;
      children_[parent->second].push_back(child->second);
    }
  }

  struct Entry {
    std::size_t link;
    std::size_t joint;  ///< that carries it, or kNone
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<Entry> order() {
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (carriers_[i] == kNone) descend(i);
    }
    for (std::size_t i = 0; i < robot_.links.size(); ++i) descend(i);  // what a cycle holds
    return std::move(order_);
  }

 private:
  void descend(std::size_t root) {
    std::vector<std::size_t> stack{root};
    while (!stack.empty()) {
      const std::size_t link = stack.back();
      stack.pop_back();
      if (visited_[link]) continue;
      visited_[link] = true;
      order_.push_back({link, carriers_[link]});
      stack.insert(stack.end(), children_[link].rbegin(), children_[link].rend());
    }
  }

  const UrdfRobot& robot_;
  std::vector<bool> visited_;
  std::vector<std::size_t> carriers_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<Entry> order_;
};

class UrdfWriter {
 public:
  std::string write(const UrdfRobot& robot) && {
    head(robot);
    for (const UrdfMaterial& material : robot.materials) write_material(material);
    std::vector<bool> written(robot.joints.size());
    for (const auto& [link, joint] : UrdfTreeOrder(robot).order()) {
      write_link(robot.links[link]);
      if (joint == UrdfTreeOrder::kNone) continue;
      write_joint(robot.joints[joint]);
      written[joint] = true;
    }
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (!written[i]) write_joint(robot.joints[i]);
    }
    for (const UrdfBlock& block : robot.blocks) write_block(block);
    for (const std::string& element : robot.rest) part(), out_.raw(element);
    out_.close();
    return "<?xml version=\"1.0\"?>\n" + std::move(out_).take();
  }

 private:
  void head(const UrdfRobot& robot) {
    std::string lines;
    for (const std::string& line : robot.head) lines += line + '\n';
    if (!lines.empty()) out_.comment(lines);
    for (const Remark& remark : robot.comments) out_.comment(remark.text);
    XmlAttributes attributes{{"name", robot.name}};
    if (!robot.version.empty()) attributes.push_back({"version", robot.version});
    out_.open("robot", attributes);
  }

  /// Begins one of the robot's parts.
  void part() {
    if (!first_) out_.blank_line();
    first_ = false;
  }

  /// Something with what its author remarked on it and in it.
  template <class Write>
  void remarked(const Remarks& comments, const Write& write) {
    if (comments.empty()) return write();
    out_.begin_remarked();
    write();
    out_.end_remarked(comments);
  }

  void write_material(const UrdfMaterial& material) {
    part();
    out_.open("material", {{"name", material.name}});
    if (material.rgba) out_.empty("color", {{"rgba", number_texts(*material.rgba)}});
    if (!material.texture.empty()) out_.empty("texture", {{"filename", material.texture}});
    out_.close();
  }

  void write_origin(const UrdfOrigin& origin) {
    XmlAttributes attributes;
    if (!all_zero(origin.xyz)) attributes.push_back({"xyz", number_texts(origin.xyz)});
    if (!all_zero(origin.rpy)) attributes.push_back({"rpy", number_texts(origin.rpy)});
    if (!attributes.empty()) out_.empty("origin", attributes);
  }

  void write_inertial(const UrdfInertial& inertial) {
    static constexpr std::array<std::string_view, 6> kNames{"ixx", "ixy", "ixz",
                                                            "iyy", "iyz", "izz"};
    remarked(inertial.comments, [&] {
      out_.open("inertial");
      write_origin(inertial.origin);
      out_.empty("mass", {{"value", to_text(inertial.mass)}});
      XmlAttributes entries;
      for (std::size_t i = 0; i < kNames.size(); ++i) {
        entries.push_back({kNames[i], to_text(inertial.inertia[i])});
      }
      out_.empty("inertia", entries);
      out_.close();
    });
  }

  struct ShapeWriter {
    XmlWriter& out;
    void operator()(const UrdfBox& box) const {
      out.empty("box", {{"size", number_texts(box.size)}});
    }
    void operator()(const UrdfSphere& sphere) const {
      out.empty("sphere", {{"radius", to_text(sphere.radius)}});
    }
    void operator()(const UrdfCylinder& shape) const {
      out.empty("cylinder", {{"radius", to_text(shape.radius)}, {"length", to_text(shape.length)}});
    }
    void operator()(const UrdfCapsule& shape) const {
      out.empty("capsule", {{"radius", to_text(shape.radius)}, {"length", to_text(shape.length)}});
    }
    void operator()(const UrdfMesh& mesh) const {
      XmlAttributes attributes{{"filename", mesh.filename}};
      if (mesh.scale) attributes.push_back({"scale", number_texts(*mesh.scale)});
      out.empty("mesh", attributes);
    }
  };

  /// Of a visual or a collision, up to its geometry; it stays open.
  template <class Part>
  void open_shape(std::string_view element, const Part& part) {
    XmlAttributes attributes;
    if (!part.name.empty()) attributes.push_back({"name", part.name});
    out_.open(element, attributes);
    write_origin(part.origin);
    out_.open("geometry");
    std::visit(ShapeWriter{out_}, part.geometry);
    out_.close();
  }

  void write_link(const UrdfLink& link) {
    part();
    for (const Remark& remark : link.comments) {
      if (!is_at_end(remark)) out_.comment(remark.text);
    }
    out_.open("link", {{"name", link.name}});
    if (link.inertial) write_inertial(*link.inertial);
    for (const UrdfVisual& visual : link.visuals) {
      remarked(visual.comments, [&] {
        open_shape("visual", visual);
        if (!visual.material.empty()) out_.empty("material", {{"name", visual.material}});
        out_.close();
      });
    }
    for (const UrdfCollision& collision : link.collisions) {
      remarked(collision.comments, [&] {
        open_shape("collision", collision);
        out_.close();
      });
    }
    for (const Remark& remark : link.comments) {
      if (is_at_end(remark)) out_.comment(remark.text);
    }
    out_.close();
  }

  void write_joint(const UrdfJoint& joint) {
    part();
    remarked(joint.comments, [&] { write_joint_itself(joint); });
  }

  void write_joint_itself(const UrdfJoint& joint) {
    out_.open("joint", {{"name", joint.name}, {"type", joint.type}});
    out_.empty("parent", {{"link", joint.parent}});
    out_.empty("child", {{"link", joint.child}});
    write_origin(joint.origin);
    if (joint.axis) out_.empty("axis", {{"xyz", number_texts(*joint.axis)}});
    if (joint.limit) write_limit(*joint.limit);
    write_dynamics(joint);
    if (joint.mimic) {
      out_.empty("mimic", {{"joint", joint.mimic->joint},
                           {"multiplier", to_text(joint.mimic->multiplier)},
                           {"offset", to_text(joint.mimic->offset)}});
    }
    if (joint.safety) {
      const auto& [lower, upper, position, velocity] = *joint.safety;
      out_.empty("safety_controller", {{"soft_lower_limit", to_text(lower)},
                                       {"soft_upper_limit", to_text(upper)},
                                       {"k_position", to_text(position)},
                                       {"k_velocity", to_text(velocity)}});
    }
    out_.close();
  }

  void write_limit(const UrdfLimit& limit) {
    XmlAttributes attributes;
    if (limit.lower) attributes.push_back({"lower", to_text(*limit.lower)});
    if (limit.upper) attributes.push_back({"upper", to_text(*limit.upper)});
    attributes.push_back({"effort", to_text(limit.effort)});
    attributes.push_back({"velocity", to_text(limit.velocity)});
    out_.empty("limit", attributes);
  }

  void write_dynamics(const UrdfJoint& joint) {
    XmlAttributes attributes;
    if (joint.damping) attributes.push_back({"damping", to_text(*joint.damping)});
    if (joint.friction) attributes.push_back({"friction", to_text(*joint.friction)});
    if (!attributes.empty()) out_.empty("dynamics", attributes);
  }

  void write_block(const UrdfBlock& block) {
    part();
    XmlAttributes attributes;
    if (!block.reference.empty()) attributes.push_back({"reference", block.reference});
    out_.open("gazebo", attributes);
    out_.raw(block.xml);
    out_.close();
  }

  XmlWriter out_;
  bool first_ = true;
};

}  // namespace

std::string urdf_text(const UrdfRobot& robot) { return UrdfWriter().write(robot); }

}  // namespace rigor::convert
