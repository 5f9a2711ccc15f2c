// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <variant>

#include <rigor/rules/kinematics/ros_model.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_not_in_urdf {

bool is_taken(const model::Shape& shape) {
  return std::holds_alternative<model::Box>(shape) ||
         std::holds_alternative<model::Sphere>(shape) ||
         std::holds_alternative<model::Cylinder>(shape) ||
         std::holds_alternative<model::Mesh>(shape) ||
         std::holds_alternative<model::NoShape>(shape);
}

template <class Entity>
void check(const Entity& entity, Context& context) {
  const model::Root& root = context.root();
  if (is_taken(entity.geometry.shape) || !entity.link) return;
  if (!may_be_for_ros(root, root[entity.link].model)) return;
  const std::string name(model::shape_name(entity.geometry.shape));
  context.report(
      {.where = entity.geometry.site.name,
       .message = "URDF has no " + name + ", and robot_state_publisher refuses the model",
       .subject = context.subject(entity)});
}

Rule rule() {
  return {
      .name = "shape-not-in-urdf",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .targets = {Target::kRos},
      .summary = "a shape is one that a robot of ROS cannot have",
      .why = "ROS reads SDF by sdformat_urdf, which makes a URDF robot of it. It knows boxes, "
             "cylinders, spheres and meshes, and refuses the whole model for any other shape.",
      .what_to_do =
          "Write a cylinder for a capsule, a sphere or a mesh for an ellipsoid, a box for a plane.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::shape_not_in_urdf
