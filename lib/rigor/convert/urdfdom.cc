// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdfdom.h>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include <rigor/robot/bytes.h>

namespace rigor::convert {
namespace {

constexpr std::string_view kUrdfdomKind = "convert.urdfdom";

constexpr double kUrdfdomEndless = std::numeric_limits<double>::infinity();

/// Of the library's, which has one handler for a process, while this lives.
class MessageKeeper final : public console_bridge::OutputHandler {
 public:
  MessageKeeper() { console_bridge::useOutputHandler(this); }
  ~MessageKeeper() override { console_bridge::restorePreviousOutputHandler(); }
  MessageKeeper(const MessageKeeper&) = delete;
  MessageKeeper& operator=(const MessageKeeper&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) messages_.push_back(text);
  }
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

model::Vector3 vector_in_urdfdom(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

model::Pose pose_in_urdfdom(const urdf::Pose& X) {
  return {vector_in_urdfdom(X.position), {X.rotation.w, X.rotation.x, X.rotation.y, X.rotation.z}};
}

robot::Shape shape_in_urdfdom(const urdf::Geometry* geometry) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry)) {
    return {"box", {box->dim.x, box->dim.y, box->dim.z}};
  }
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry)) {
    return {"sphere", {sphere->radius}};
  }
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry)) {
    return {"cylinder", {cylinder->radius, cylinder->length}};
  }
  if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(geometry)) {
    return {"mesh", {mesh->scale.x, mesh->scale.y, mesh->scale.z}, mesh->filename};
  }
  return {"none"};
}

template <class Part>
robot::Part part_in_urdfdom(const Part& part) {
  return {part.name, pose_in_urdfdom(part.origin), shape_in_urdfdom(part.geometry.get())};
}

/// The tensor stands along the axes of the inertial's origin.
mass::MassProperties mass_in_urdfdom(const urdf::Inertial& i) {
  return mass::transformed(pose_in_urdfdom(i.origin),
                           {i.mass, {}, {i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz}});
}

robot::Body body_in_urdfdom(const urdf::Link& link) {
  robot::Body body;
  body.name = link.name;
  if (link.inertial) body.mass = mass_in_urdfdom(*link.inertial);
  for (const auto& collision : link.collision_array) {
    body.collisions.push_back(part_in_urdfdom(*collision));
  }
  for (const auto& visual : link.visual_array) {
    body.visuals.push_back(part_in_urdfdom(*visual));
    if (!visual->material || !visual->material->texture_filename.empty()) continue;
    const urdf::Color& color = visual->material->color;
    body.visuals.back().color = robot::Color{color.r, color.g, color.b, color.a};
  }
  return body;
}

model::JointType type_in_urdfdom(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS: return model::JointType::kRevolute;
    case urdf::Joint::PRISMATIC: return model::JointType::kPrismatic;
    case urdf::Joint::FLOATING: return model::JointType::kFloating;
    case urdf::Joint::PLANAR: return model::JointType::kPlanar;
    case urdf::Joint::FIXED: return model::JointType::kFixed;
    default: return model::JointType::kUnknown;
  }
}

robot::Axis axis_in_urdfdom(const urdf::Joint& joint) {
  robot::Axis axis;
  const model::Vector3 direction = vector_in_urdfdom(joint.axis);
  const double size = length(direction);
  if (size > 0) axis.direction = 1 / size * direction;
  if (joint.type == urdf::Joint::PRISMATIC) axis.motion = robot::Axis::Motion::kSlide;
  if (joint.limits) {
    axis.lower = robot::without_sentinel(joint.limits->lower);
    axis.upper = robot::without_sentinel(joint.limits->upper);
    axis.effort = robot::ceiling(joint.limits->effort);
    axis.velocity = robot::ceiling(joint.limits->velocity);
  } else {
    axis.effort = axis.velocity = kUrdfdomEndless;
  }
  if (joint.type == urdf::Joint::CONTINUOUS) {
    axis.lower = -kUrdfdomEndless;
    axis.upper = kUrdfdomEndless;
  }
  if (joint.dynamics) {
    axis.damping = joint.dynamics->damping;
    axis.friction = joint.dynamics->friction;
  }
  if (joint.mimic) {
    axis.follow =
        robot::Mimic{joint.mimic->joint_name, 0, joint.mimic->multiplier, joint.mimic->offset};
  }
  return axis;
}

robot::Joint joint_in_urdfdom(const urdf::Joint& joint,
                              const std::map<std::string, std::uint32_t>& bodies) {
  robot::Joint result;
  result.name = joint.name;
  result.type = type_in_urdfdom(joint);
  result.parent = bodies.at(joint.parent_link_name);
  result.child = bodies.at(joint.child_link_name);
  result.X_PJ = pose_in_urdfdom(joint.parent_to_joint_origin_transform);
  if (result.type == model::JointType::kPlanar) {
    result.axes = robot::planar_axes(axis_in_urdfdom(joint).direction);
  } else if (result.type != model::JointType::kFixed &&
             result.type != model::JointType::kFloating) {
    result.axes.push_back(axis_in_urdfdom(joint));
  }
  return result;
}

/// In the worker.
process::Reply parse_by_urdfdom(const std::string& text, const process::Ask& /*ask*/) {
  const MessageKeeper keeper;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  robot::ByteWriter out;
  out.count(keeper.messages().size());
  for (const std::string& message : keeper.messages()) out.text(message);
  out.count(model ? 1 : 0);
  if (!model) return out.take();
  robot::Robot robot;
  robot.name = model->getName();
  std::map<std::string, std::uint32_t> bodies;
  for (const auto& [name, link] : model->links_) {
    bodies.emplace(name, static_cast<std::uint32_t>(robot.bodies.size()));
    robot.bodies.push_back(body_in_urdfdom(*link));
  }
  for (const auto& [name, joint] : model->joints_) {
    robot.joints.push_back(joint_in_urdfdom(*joint, bodies));
  }
  robot::write_robot(out, robot);
  return out.take();
}

}  // namespace

UrdfdomVerdict judge_by_urdfdom(std::string_view urdf, const process::Workers& workers) {
  const process::RequestResult result =
      workers.call({.kind = kUrdfdomKind, .bytes = std::string(urdf), .limits = kUrdfdomLimits});
  UrdfdomVerdict verdict;
  verdict.died = result.end != process::RequestResult::End::kDone;
  if (verdict.died) {
    verdict.messages.push_back("urdfdom " + process::describe(result, kUrdfdomLimits));
    return verdict;
  }
  robot::ByteReader in(result.bytes);
  for (std::size_t left = in.count(); left > 0; --left) verdict.messages.push_back(in.text());
  if (in.count() > 0) verdict.robot = robot::read_robot(in);
  return verdict;
}

process::Service urdfdom_service() { return {kUrdfdomKind, parse_by_urdfdom}; }

}  // namespace rigor::convert
