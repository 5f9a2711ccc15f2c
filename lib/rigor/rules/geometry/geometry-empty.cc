// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/rule.h>

namespace rigor::rules::geometry_empty {

template <class Part>
void check(const Part& part, Context& context) {
  const model::Geometry& geometry = part.geometry;
  if (!geometry.written || geometry.explicitly_empty) return;
  if (!std::holds_alternative<model::NoShape>(geometry.shape)) return;
  const Span other = geometry.no_shape.name;
  if (!other.nowhere() && !context.is_urdf()) return;  // unknown-element
  context.report({.where = other.nowhere() ? geometry.site.name : other,
                  .message = other.nowhere() ? "the geometry holds no shape"
                                             : "<" + std::string(context.bytes(other)) +
                                                   "> is no shape of URDF",
                  .subject = context.subject(part),
                  .help = other.nowhere() ? "" : "use box, cylinder, sphere or mesh"});
}

Rule rule() {
  return {
      .name = "geometry-empty",
      .severity = Severity::kError,
      .summary = "a <geometry> holds no shape",
      .why = "urdfdom stops reading the link with an error: this part and all that follow are not "
             "there, first the visuals, then the collisions. libsdformat accepts it, and the part "
             "has no shape.",
      .what_to_do = "Add a shape, or remove the visual or collision. Where nothing is meant, SDF "
                    "has <empty/>.",
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::geometry_empty
