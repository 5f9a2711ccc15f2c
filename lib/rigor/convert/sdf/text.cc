// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/number_text.h>
#include <rigor/convert/sdf/robot.h>
#include <rigor/convert/xml_writer.h>

namespace rigor::convert {
namespace {

class SdfWriter {
 public:
  std::string write(const SdfRobot& robot) && {
    std::string lines;
    for (const std::string& line : robot.head) lines += line + '\n';
    if (!lines.empty()) out_.comment(lines);
    for (const Remark& remark : robot.comments) out_.comment(remark.text);
    out_.open("sdf", {{"version", "1." + std::to_string(robot.version)}});
    out_.open("model", {{"name", robot.name}});
    for (const SdfElement& element : robot.settings) write_element(element);
    bool first = robot.settings.empty();
    for (const SdfPart& part : robot.parts) {
      // A frame stands with what it is attached to.
      const bool apart = !std::holds_alternative<SdfFrame>(part);
      if (apart && !std::exchange(first, false)) out_.blank_line();
      std::visit([this](const auto& one) { write_part(one); }, part);
    }
    for (const std::string& raw : robot.raw) {
      out_.blank_line();
      out_.raw(raw);
    }
    out_.close();
    out_.close();
    return "<?xml version=\"1.0\"?>\n" + std::move(out_).take();
  }

 private:
  /// Trees are as deep as what they were read from, at most xml::kMaxDepth.
  void write_element(const SdfElement& element) {
    XmlAttributes attributes;
    for (const auto& [name, value] : element.attributes) attributes.push_back({name, value});
    if (element.children.empty() && !element.text.empty()) {
      out_.text(element.name, element.text, attributes);
      return;
    }
    out_.open(element.name, attributes);
    for (const SdfElement& child : element.children) write_element(child);
    out_.close();
  }

  void write_elements(const std::vector<SdfElement>& elements) {
    for (const SdfElement& element : elements) write_element(element);
  }

  void write_pose(const SdfPose& pose) {
    XmlAttributes attributes;
    if (!pose.relative_to.empty()) attributes.push_back({"relative_to", pose.relative_to});
    if (!is_identity(pose.origin)) {
      const std::string text = number_texts(pose.origin.xyz) + ' ' + number_texts(pose.origin.rpy);
      out_.text("pose", text, attributes);
    } else if (!attributes.empty()) {
      out_.empty("pose", attributes);
    }
  }

  /// Something with what its author remarked on it and in it.
  template <class Write>
  void remarked(const Remarks& comments, const Write& write) {
    if (comments.empty()) return write();
    out_.begin_remarked();
    write();
    out_.end_remarked(comments);
  }

  void write_inertial(const UrdfInertial& inertial) {
    remarked(inertial.comments, [&] { write_inertial_itself(inertial); });
  }

  void write_inertial_itself(const UrdfInertial& inertial) {
    static constexpr std::array<std::string_view, 6> kNames{"ixx", "ixy", "ixz",
                                                            "iyy", "iyz", "izz"};
    out_.open("inertial");
    write_pose({{}, inertial.origin});
    out_.text("mass", to_text(inertial.mass));
    out_.open("inertia");
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      out_.text(kNames[i], to_text(inertial.inertia[i]));
    }
    out_.close();
    out_.close();
  }

  struct GeometryWriter {
    XmlWriter& out;
    void round(std::string_view name, const Number& radius, const Number& length) const {
      out.open(name);
      out.text("radius", to_text(radius));
      out.text("length", to_text(length));
      out.close();
    }
    void operator()(const UrdfBox& box) const {
      out.open("box");
      out.text("size", number_texts(box.size));
      out.close();
    }
    void operator()(const UrdfSphere& sphere) const {
      out.open("sphere");
      out.text("radius", to_text(sphere.radius));
      out.close();
    }
    void operator()(const UrdfCylinder& s) const { round("cylinder", s.radius, s.length); }
    void operator()(const UrdfCapsule& s) const { round("capsule", s.radius, s.length); }
    void operator()(const UrdfMesh& mesh) const {
      out.open("mesh");
      out.text("uri", mesh.filename);
      if (mesh.scale) out.text("scale", number_texts(*mesh.scale));
      out.close();
    }
  };

  void write_shape(std::string_view element, const SdfShape& shape) {
    remarked(shape.comments, [&] {
      out_.open(element, {{"name", shape.name}});
      write_pose(shape.pose);
      out_.open("geometry");
      if (shape.other_geometry) {
        write_element(*shape.other_geometry);
      } else {
        std::visit(GeometryWriter{out_}, shape.geometry);
      }
      out_.close();
      write_elements(shape.rest);
      out_.close();
    });
  }

  void write_part(const SdfLink& link) {
    for (const Remark& remark : link.comments) {
      if (!is_at_end(remark)) out_.comment(remark.text);
    }
    out_.open("link", {{"name", link.name}});
    write_pose(link.pose);
    write_elements(link.settings);
    if (link.inertial) write_inertial(*link.inertial);
    for (const SdfShape& visual : link.visuals) write_shape("visual", visual);
    for (const SdfShape& collision : link.collisions) write_shape("collision", collision);
    for (const std::string& raw : link.raw) out_.raw(raw);
    for (const Remark& remark : link.comments) {
      if (is_at_end(remark)) out_.comment(remark.text);
    }
    out_.close();
  }

  void write_part(const SdfJoint& joint) {
    remarked(joint.comments, [&] { write_joint(joint); });
  }

  void write_joint(const SdfJoint& joint) {
    out_.open("joint", {{"name", joint.name}, {"type", joint.type}});
    write_pose(joint.pose);
    out_.text("parent", joint.parent);
    out_.text("child", joint.child);
    if (joint.axis) write_axis(*joint.axis);
    write_elements(joint.rest);
    for (const std::string& raw : joint.raw) out_.raw(raw);
    out_.close();
  }

  void write_axis(const SdfAxis& axis) {
    out_.open("axis");
    out_.text("xyz", number_texts(axis.xyz));
    write_elements(axis.rest);
    if (axis.mimic) {
      out_.open("mimic", {{"joint", axis.mimic->joint}});
      out_.text("multiplier", to_text(axis.mimic->multiplier));
      out_.text("offset", to_text(axis.mimic->offset));
      out_.text("reference", "0");
      out_.close();
    }
    out_.close();
  }

  void write_part(const SdfFrame& frame) {
    for (const Remark& remark : frame.comments) out_.comment(remark.text);
    out_.open("frame", {{"name", frame.name}, {"attached_to", frame.attached_to}});
    write_pose(frame.pose);
    out_.close();
  }

  XmlWriter out_;
};

}  // namespace

void SdfElement::set(std::string_view path, std::string value) {
  SdfElement* element = this;
  while (!path.empty()) {
    const std::string_view step = path.substr(0, path.find('/'));
    path.remove_prefix(std::min(step.size() + 1, path.size()));
    auto& inside = element->children;
    auto found = std::find_if(inside.begin(), inside.end(),
                              [step](const SdfElement& e) { return e.name == step; });
    if (found == inside.end()) found = inside.insert(inside.end(), {.name = std::string(step)});
    element = &*found;
  }
  element->text = std::move(value);
}

std::string sdf_text(const SdfRobot& robot) { return SdfWriter().write(robot); }

}  // namespace rigor::convert
