// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/rule.h>

namespace rigor::rules::shape_newer_than_urdf {

template <class Entity>
void check(const Entity& entity, Context& context) {
  const bool capsule = std::holds_alternative<model::Capsule>(entity.geometry.shape);
  if (!capsule || context.root().version >= 1) return;
  context.report(
      {.where = entity.geometry.site.name,
       .message = "<capsule> is a shape of URDF 1.1, and this file is URDF 1.0: urdfdom rejects it",
       .subject = context.subject(entity)});
}

Rule rule() {
  return {
      .name = "shape-newer-than-urdf",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .summary = "a shape is newer than the version of the file",
      .why = "urdfdom supports capsules since 5.1, in files of version 1.1. Otherwise it logs an "
             "error and stops reading the link: robot_state_publisher, RViz, MoveIt and Gazebo "
             "have neither this visual or collision nor those that follow. Pinocchio and Drake "
             "have readers of their own and accept it.",
      .what_to_do = "Write version=\"1.1\" at <robot> where urdfdom is new enough, or use a "
                    "cylinder and two spheres.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::shape_newer_than_urdf
