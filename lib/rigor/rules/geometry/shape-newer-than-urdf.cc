// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/rule.h>

namespace rigor::rules::shape_newer_than_urdf {

template <class Entity>
void check(const Entity& entity, Context& context) {
  const bool capsule = std::holds_alternative<model::Capsule>(entity.geometry.shape);
  if (!capsule || context.root().version >= 1) return;
  context.report({.where = entity.geometry.site.name,
                  .message = "URDF has capsules from 1.1 on: this file is URDF 1.0",
                  .subject = context.subject(entity)});
}

Rule rule() {
  return {
      .name = "shape-newer-than-urdf",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .summary = "a shape is newer than the version of the file",
      .why = "urdfdom knows capsules since 5.1, in files of version 1.1; else it stops reading the "
             "link here, and RViz and MoveIt have neither this part nor those that follow. "
             "Pinocchio, Drake and others have readers of their own and take it.",
      .what_to_do = "Write version=\"1.1\" at <robot> where urdfdom is new enough, or a cylinder "
                    "and two spheres.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::shape_newer_than_urdf
