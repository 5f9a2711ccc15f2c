// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/written_robot.h>

#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using model::JointType;
using model::Pose;
using robot::kNoIndex;

constexpr double kNone = std::numeric_limits<double>::infinity();

std::string word_of(xml::Element element, std::string_view attribute) {
  const auto found = element.attribute(attribute);
  return found ? std::string(found->value()) : std::string();
}

std::vector<double> numbers_of(xml::Element element, std::string_view attribute,
                               std::vector<double> otherwise) {
  const auto found = element.attribute(attribute);
  const auto numbers = found ? write::numbers_in(found->value()) : std::nullopt;
  return numbers && numbers->size() >= otherwise.size() ? *numbers : std::move(otherwise);
}

double number_of(xml::Element element, std::string_view attribute, double otherwise) {
  return numbers_of(element, attribute, {otherwise})[0];
}

Pose pose_of_element(xml::Element element) {
  const auto p = numbers_of(element, "pos", {0, 0, 0});
  const auto q = numbers_of(element, "quat", {1, 0, 0, 0});
  return {{p[0], p[1], p[2]}, model::normalized({q[0], q[1], q[2], q[3]})};
}

bool is_joint(std::string_view name) { return name == "joint" || name == "freejoint"; }

class MjcfReader {
 public:
  explicit MjcfReader(const xml::Document& document) : document_(document) {}

  std::optional<robot::Robot> read() {
    const auto root = document_.root();
    if (!root || root->name() != "mujoco" || !document_.complete()) return std::nullopt;
    const auto world = root->child("worldbody");
    if (!world) return std::nullopt;
    robot_.name = word_of(*root, "model");
    robot_.X_WM = Pose{};
    if (const auto equality = root->child("equality")) read_couplings(*equality);
    read_bodies(*world);
    if (const auto actuators = root->child("actuator")) read_actuators(*actuators);
    robot::connect(robot_);
    return std::move(robot_);
  }

 private:
  struct Coupling {
    std::string leader;
    double offset = 0, slope = 0;
  };

  void read_couplings(xml::Element equality) {
    for (const xml::Element child : equality.children()) {
      if (child.name() != "joint") continue;
      const auto c = numbers_of(child, "polycoef", {0, 1});
      couplings_[word_of(child, "joint1")] = {word_of(child, "joint2"), c[0], c[1]};
    }
  }

  void read_bodies(xml::Element world) {
    struct Item {
      xml::Element element;
      std::uint32_t parent;
    };
    world_ = add_body(robot::kWorldBody);
    read_shapes(world, robot_.bodies[world_]);
    std::vector<Item> stack;
    const auto push = [&stack](xml::Element element, std::uint32_t index) {
      for (const xml::Element child : element.children()) {
        if (child.name() == "body") stack.push_back({child, index});
      }
    };
    push(world, world_);
    while (!stack.empty()) {
      const Item item = stack.back();
      stack.pop_back();
      push(item.element, read_body(item.element, item.parent));
    }
  }

  std::uint32_t add_body(const std::string& name) {
    robot_.bodies.push_back({name});
    return static_cast<std::uint32_t>(robot_.bodies.size() - 1);
  }

  std::uint32_t read_body(xml::Element element, std::uint32_t parent) {
    const std::string name = word_of(element, "name");
    const Pose X = pose_of_element(element);
    std::vector<xml::Element> joints;
    for (const xml::Element child : element.children()) {
      if (is_joint(child.name())) joints.push_back(child);
    }
    std::uint32_t body = 0;
    if (joints.empty()) {
      body = add_body(name);
      add_joint(mjcf_fixed_name(name), JointType::kFixed, parent, body, X);
    } else if (joints[0].name() == "freejoint") {
      body = add_body(name);
      if (word_of(joints[0], "name") == name + "_free") {
        robot_.bodies[body].X_MB = X;
      } else {
        add_joint(word_of(joints[0], "name"), JointType::kFloating, parent, body, X);
      }
    } else {
      body = read_chain(name, joints, parent, X);
    }
    if (const auto inertial = element.child("inertial")) {
      robot_.bodies[body].mass = read_inertial(*inertial);
    }
    read_shapes(element, robot_.bodies[body]);
    return body;
  }

  /// Each joint but the last carries a body without mass.
  std::uint32_t read_chain(const std::string& name, const std::vector<xml::Element>& joints,
                           std::uint32_t parent, Pose X) {
    const bool floats = joints.size() == 4 && word_of(joints[3], "type") == "ball";
    for (std::size_t k = floats ? 3 : 0; k < joints.size(); ++k) {
      const std::string joint = word_of(joints[k], "name");
      const std::string type = word_of(joints[k], "type");
      const auto thread = couplings_.find(joint);
      const bool last = k + 1 == joints.size();
      const bool screw = !last && type == "slide" && thread != couplings_.end() &&
                         thread->second.leader == word_of(joints[k + 1], "name") &&
                         joint == thread->second.leader + "_slide";
      if (screw) continue;  // read with the hinge that it follows
      const std::uint32_t body = add_body(last ? name : name + '/' + std::to_string(k));
      JointType kind = type == "slide" ? JointType::kPrismatic : JointType::kRevolute;
      if (type == "ball") kind = floats ? JointType::kFloating : JointType::kBall;
      robot::Joint& added = add_joint(joint, kind, parent, body, X);
      if (kind == JointType::kPrismatic || kind == JointType::kRevolute) {
        added.axes.push_back(read_axis(joints[k], joint));
        if (k > 0) read_thread(joints[k - 1], added);
      }
      X = {};
      parent = body;
    }
    return parent;
  }

  void read_thread(xml::Element slide, robot::Joint& hinge) {
    const auto thread = couplings_.find(word_of(slide, "name"));
    if (thread == couplings_.end() || thread->second.leader != hinge.name) return;
    if (word_of(slide, "name") != hinge.name + "_slide") return;
    hinge.type = JointType::kScrew;
    hinge.axes[0].motion = robot::Axis::Motion::kScrew;
    hinge.axes[0].slide = thread->second.slope;
  }

  robot::Joint& add_joint(const std::string& name, JointType type, std::uint32_t parent,
                          std::uint32_t child, const Pose& X_PJ) {
    robot::Joint joint;
    joint.name = name;
    joint.type = type;
    joint.parent = parent;
    joint.child = child;
    joint.X_PJ = X_PJ;
    if (type == JointType::kBall) {
      for (const model::Vector3& d : {model::Vector3{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}) {
        joint.axes.push_back({.direction = d, .lower = -kNone, .upper = kNone});
        joint.axes.back().effort = joint.axes.back().velocity = kNone;
      }
    }
    robot_.joints.push_back(std::move(joint));
    return robot_.joints.back();
  }

  robot::Axis read_axis(xml::Element element, const std::string& name) const {
    robot::Axis axis;
    if (word_of(element, "type") == "slide") axis.motion = robot::Axis::Motion::kSlide;
    const auto d = numbers_of(element, "axis", {0, 0, 1});
    axis.direction = {d[0], d[1], d[2]};
    const double size = length(axis.direction);
    if (size > 0) axis.direction = 1 / size * axis.direction;
    axis.lower = -kNone;
    axis.upper = axis.effort = axis.velocity = kNone;
    if (word_of(element, "limited") == "true") {
      const auto range = numbers_of(element, "range", {-kNone, kNone});
      if (range[0] > -kMjcfUnlimited) axis.lower = range[0];
      if (range[1] < kMjcfUnlimited) axis.upper = range[1];
    }
    axis.damping = number_of(element, "damping", 0);
    axis.friction = number_of(element, "frictionloss", 0);
    axis.spring_stiffness = number_of(element, "stiffness", 0);
    axis.spring_reference = number_of(element, "springref", 0);
    const auto coupling = couplings_.find(name);
    if (coupling == couplings_.end()) return axis;
    if (coupling->second.leader.empty()) {
      axis.lower = axis.upper = coupling->second.offset;
    } else {
      axis.follow =
          robot::Mimic{coupling->second.leader, 0, coupling->second.slope, coupling->second.offset};
    }
    return axis;
  }

  static mass::MassProperties read_inertial(xml::Element element) {
    const auto m = numbers_of(element, "diaginertia", {0, 0, 0});
    const Pose X = pose_of_element(element);
    return {number_of(element, "mass", 0), X.translation,
            mass::rotated(X.rotation, {m[0], 0, 0, m[1], 0, m[2]})};
  }

  static void read_shapes(xml::Element element, robot::Body& body) {
    for (const xml::Element geom : element.children()) {
      if (geom.name() != "geom") continue;
      robot::Part part;
      part.X_BS = pose_of_element(geom);
      part.shape.kind = word_of(geom, "type");
      const auto found = geom.attribute("size");
      const auto size = found ? write::numbers_in(found->value()) : std::nullopt;
      if (size) part.shape.numbers = *size;
      auto& n = part.shape.numbers;
      if (part.shape.kind == "box") {
        for (double& side : n) side *= 2;
      } else if ((part.shape.kind == "cylinder" || part.shape.kind == "capsule") && n.size() == 2) {
        n[1] *= 2;
      } else if (part.shape.kind == "plane") {
        n = {0, 0, 1};
      }
      const bool visual = word_of(geom, "class") == "visual";
      (visual ? body.visuals : body.collisions).push_back(std::move(part));
    }
  }

  void read_actuators(xml::Element actuators) {
    std::map<std::string, double> efforts;
    for (const xml::Element actuator : actuators.children()) {
      const bool motor = actuator.name() == "motor";
      const auto range = numbers_of(actuator, motor ? "ctrlrange" : "forcerange", {-kNone, kNone});
      efforts[word_of(actuator, "joint")] = range[1];
    }
    for (robot::Joint& joint : robot_.joints) {
      const auto found = efforts.find(joint.name);
      if (found != efforts.end() && !joint.axes.empty()) joint.axes[0].effort = found->second;
    }
  }

  const xml::Document& document_;
  robot::Robot robot_;
  std::uint32_t world_ = kNoIndex;
  std::map<std::string, Coupling> couplings_;
};

}  // namespace

std::string mjcf_fixed_name(const std::string& body) { return "fixed:" + body; }

std::optional<robot::Robot> written_mjcf_robot(const std::string& text) {
  const xml::Document document = xml::parse(text, {});
  return MjcfReader(document).read();
}

}  // namespace rigor::convert
