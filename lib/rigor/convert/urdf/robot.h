// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A URDF file as it will be written: plain structs, one per element, in the order of the file. Made by
// `sdf_to_urdf`, written by `urdf_text`.
//
// A number keeps the text that its author gave it wherever it means the same in the target.
//
//   UrdfLink link{.name = "chassis"};
//   link.collisions.push_back({.origin = origin_of(X_LC), .geometry = UrdfBox{numbers({1, 1, 1})}});

#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/remark.h>
#include <rigor/model/pose.h>

namespace rigor::mass {
struct Inertia;
struct MassProperties;
}  // namespace rigor::mass

namespace rigor::convert {

/// A number and how it is written: the author's own text, or the shortest that reads back the same.
struct Number {
  double value = 0;
  std::string text;  ///< empty: the shortest
};

std::string to_text(const Number& number);

using Number3 = std::array<Number, 3>;
Number3 numbers(const model::Vector3& v);

/// `<origin>`: meters, and roll, pitch, yaw in radians.
struct UrdfOrigin {
  Number3 xyz;
  Number3 rpy;
};

/// Near a pitch of ±90° roll is 0 and yaw takes all, so that the rotation is right to the last digits.
UrdfOrigin origin_of(const model::Pose& X);
bool is_identity(const UrdfOrigin& origin);
model::Pose pose_of(const UrdfOrigin& origin);

struct UrdfInertial {
  UrdfOrigin origin;              ///< of the center of mass frame
  Number mass;                    ///< kg
  std::array<Number, 6> inertia;  ///< ixx ixy ixz iyy iyz izz, kg·m²
  Remarks comments = {};
};

std::array<Number, 6> tensor_entries(const mass::Inertia& I);
/// Of a body whose center of mass frame has its own axes.
UrdfInertial inertial_of(const mass::MassProperties& body);

struct UrdfBox {
  Number3 size;
};
struct UrdfCylinder {
  Number radius, length;
};
struct UrdfSphere {
  Number radius;
};
struct UrdfCapsule {  ///< URDF 1.1
  Number radius, length;
};
struct UrdfMesh {
  std::string filename;
  std::optional<Number3> scale;
};
using UrdfGeometry = std::variant<UrdfBox, UrdfCylinder, UrdfSphere, UrdfCapsule, UrdfMesh>;

struct UrdfMaterial {
  std::string name;
  std::optional<std::array<Number, 4>> rgba;
  std::string texture;
};

struct UrdfVisual {
  std::string name;
  UrdfOrigin origin;
  UrdfGeometry geometry;
  std::string material;  ///< name of one of the robot's; empty for none
  Remarks comments = {};
};

struct UrdfCollision {
  std::string name;
  UrdfOrigin origin;
  UrdfGeometry geometry;
  Remarks comments = {};
};

struct UrdfLink {
  std::string name;
  std::optional<UrdfInertial> inertial;
  std::vector<UrdfVisual> visuals;
  std::vector<UrdfCollision> collisions;
  Remarks comments = {};
};

struct UrdfLimit {
  std::optional<Number> lower, upper;  ///< rad or m
  Number effort, velocity;
};

struct UrdfMimic {
  std::string joint;
  Number multiplier, offset;
};

struct UrdfJoint {
  std::string name;
  std::string type;  ///< fixed, revolute, continuous, prismatic, floating, planar
  std::string parent, child;
  UrdfOrigin origin;  ///< of the joint in the parent link's frame
  std::optional<Number3> axis;
  std::optional<UrdfLimit> limit;
  std::optional<Number> damping, friction;
  std::optional<UrdfMimic> mimic;
  std::optional<std::array<Number, 4>> safety;  ///< soft lower, soft upper, k_position, k_velocity
  Remarks comments = {};
};

/// `<gazebo reference="…">`, or of the whole robot; `xml` is what stands in it, laid out with two
/// spaces a level, lines ended by '\n'.
struct UrdfBlock {
  std::string reference;
  std::string xml;
};

struct UrdfRobot {
  std::string name;
  std::string version;            ///< empty: 1.0, which is not written
  std::vector<std::string> head;  ///< lines of the comment at the head
  Remarks comments;               ///< at the head of the source
  std::vector<UrdfMaterial> materials;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::vector<UrdfBlock> blocks;
  std::vector<std::string> rest;  ///< further elements as they are: transmission, ros2_control
};

/// The file. Each joint follows the links that it names; two spaces a level; materials first, blocks
/// last; numbers never "-0", never "inf".
std::string urdf_text(const UrdfRobot& robot);

}  // namespace rigor::convert
