// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/bytes.h>

#include <map>

namespace rigor::robot {
namespace {

void write_vector_bytes(ByteWriter& out, const model::Vector3& v) {
  for (const double each : {v.x, v.y, v.z}) out.number(each);
}

void write_pose_bytes(ByteWriter& out, const model::Pose& X) {
  write_vector_bytes(out, X.translation);
  for (const double each : {X.rotation.w, X.rotation.x, X.rotation.y, X.rotation.z}) {
    out.number(each);
  }
}

void write_parts_bytes(ByteWriter& out, const std::vector<Part>& parts) {
  out.count(parts.size());
  for (const Part& part : parts) {
    out.text(part.name);
    write_pose_bytes(out, part.X_BS);
    out.text(part.shape.kind);
    out.count(part.shape.numbers.size());
    for (const double each : part.shape.numbers) out.number(each);
    out.text(part.shape.uri);
    out.count(part.color ? 1 : 0);
    if (part.color) {
      for (const double each : {part.color->r, part.color->g, part.color->b, part.color->a}) {
        out.number(each);
      }
    }
  }
}

void write_axis_bytes(ByteWriter& out, const Axis& axis) {
  out.count(static_cast<std::size_t>(axis.motion));
  write_vector_bytes(out, axis.direction);
  for (const double each :
       {axis.lower, axis.upper, axis.effort, axis.velocity, axis.damping, axis.friction}) {
    out.number(each);
  }
  out.count(axis.follow ? 1 : 0);
  if (!axis.follow) return;
  out.text(axis.follow->joint);
  out.number(axis.follow->multiplier);
  out.number(axis.follow->offset);
}

model::Vector3 read_vector_bytes(ByteReader& in) {
  const double x = in.number(), y = in.number(), z = in.number();
  return {x, y, z};
}

model::Pose read_pose_bytes(ByteReader& in) {
  const model::Vector3 translation = read_vector_bytes(in);
  const double w = in.number();
  const model::Vector3 v = read_vector_bytes(in);
  return {translation, {w, v.x, v.y, v.z}};
}

std::vector<Part> read_parts_bytes(ByteReader& in) {
  std::vector<Part> parts(in.count());
  for (Part& part : parts) {
    part.name = in.text();
    part.X_BS = read_pose_bytes(in);
    part.shape.kind = in.text();
    part.shape.numbers.resize(in.count());
    for (double& each : part.shape.numbers) each = in.number();
    part.shape.uri = in.text();
    if (in.count() == 0) continue;
    const double r = in.number(), g = in.number(), b = in.number(), a = in.number();
    part.color = Color{r, g, b, a};
  }
  return parts;
}

Axis read_axis_bytes(ByteReader& in) {
  Axis axis;
  axis.motion = static_cast<Axis::Motion>(in.count());
  axis.direction = read_vector_bytes(in);
  for (double* each :
       {&axis.lower, &axis.upper, &axis.effort, &axis.velocity, &axis.damping, &axis.friction}) {
    *each = in.number();
  }
  if (in.count() == 0) return axis;
  axis.follow.emplace();
  axis.follow->joint = in.text();
  axis.follow->multiplier = in.number();
  axis.follow->offset = in.number();
  return axis;
}

}  // namespace

void write_robot(ByteWriter& out, const Robot& robot) {
  out.text(robot.name);
  out.count(robot.bodies.size());
  for (const Body& body : robot.bodies) {
    out.text(body.name);
    out.number(body.mass.mass);
    write_vector_bytes(out, body.mass.com);
    const mass::Inertia& i = body.mass.about_com;
    for (const double each : {i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz}) out.number(each);
    write_parts_bytes(out, body.collisions);
    write_parts_bytes(out, body.visuals);
  }
  out.count(robot.joints.size());
  for (const Joint& joint : robot.joints) {
    out.text(joint.name);
    out.count(static_cast<std::size_t>(joint.type));
    out.text(robot.bodies[joint.parent].name);
    out.text(robot.bodies[joint.child].name);
    write_pose_bytes(out, joint.X_PJ);
    out.count(joint.axes.size());
    for (const Axis& axis : joint.axes) write_axis_bytes(out, axis);
  }
}

std::optional<Robot> read_robot(ByteReader& in) {
  Robot robot;
  robot.name = in.text();
  robot.bodies.resize(in.count());
  std::map<std::string, std::uint32_t> by_name;
  for (std::uint32_t n = 0; n < robot.bodies.size(); ++n) {
    Body& body = robot.bodies[n];
    body.name = in.text();
    by_name.try_emplace(body.name, n);
    body.mass.mass = in.number();
    body.mass.com = read_vector_bytes(in);
    mass::Inertia& i = body.mass.about_com;
    for (double* each : {&i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz}) *each = in.number();
    body.collisions = read_parts_bytes(in);
    body.visuals = read_parts_bytes(in);
  }
  robot.joints.resize(in.count());
  for (Joint& joint : robot.joints) {
    joint.name = in.text();
    joint.type = static_cast<model::JointType>(in.count());
    const auto parent = by_name.find(in.text());
    const auto child = by_name.find(in.text());
    if (parent == by_name.end() || child == by_name.end()) return std::nullopt;
    joint.parent = parent->second;
    joint.child = child->second;
    joint.X_PJ = read_pose_bytes(in);
    joint.axes.resize(in.count());
    for (Axis& axis : joint.axes) axis = read_axis_bytes(in);
  }
  if (!in.good()) return std::nullopt;
  connect(robot);
  return robot;
}

}  // namespace rigor::robot
