// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <variant>

#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::automatic_inertia_unsupported_shape {

bool is_supported(const model::Shape& shape) {
  return !std::holds_alternative<model::Plane>(shape) &&
         !std::holds_alternative<model::Heightmap>(shape) &&
         !std::holds_alternative<model::Image>(shape) &&
         !std::holds_alternative<model::Polyline>(shape);
}

void check(const model::Collision& collision, Context& context) {
  const model::Geometry& geometry = collision.geometry;
  if (is_supported(geometry.shape)) return;
  const model::Link& link = context.root()[collision.link];
  if (!is_computed(link, context)) return;
  context.report(
      {.where = geometry.site.name,
       .message = "the link's inertia is to be computed from its collisions, and of a <" +
                  std::string(model::shape_name(geometry.shape)) + "> none can be computed",
       .subject = context.subject(collision),
       .related = {{link.inertial.automatic.span, "asked for here"}}});
}

Rule rule() {
  return {
      .name = "automatic-inertia-unsupported-shape",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "an automatic inertial is to be computed from a shape without a computable mass",
      .why = "libsdformat 14 and later compute boxes, capsules, cones, cylinders, ellipsoids, "
             "spheres and, within Gazebo, meshes. Of a plane, heightmap, image or polyline they "
             "report that the inertia is invalid.",
      .what_to_do = "Use another shape, or write mass and tensor: `rigor inertia MODEL --write` "
                    "computes those of a polyline.",
      .checks = {on<model::Collision>(check)},
  };
}

}  // namespace rigor::rules::automatic_inertia_unsupported_shape
