// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_about_link_origin {

void check(const model::Link& link, Context& context) {
  if (link.inertial.pose.pose.value.translation == model::Vector3{}) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kAboutLinkOrigin) return;
  const model::Inertial& inertial = link.inertial;
  const double distance = model::length(inertial.pose.pose.value.translation);
  context.report({.where = inertial.tensor_site.name,
                  .message = fmt::format(
                      "the tensor is what the link's shapes have about the link's origin, {:.3g} m "
                      "from the center of mass: {} kg at that distance are counted twice",
                      distance, inertial.mass.value),
                  .subject = context.subject(link),
                  .fix = fix_from_shapes(link, context)});
}

Rule rule() {
  return {
      .name = "inertia-about-link-origin",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an inertia tensor is about the link's origin instead of the center of mass",
      .why = "A tensor about the origin of the link is moved twice, so that the link rotates too "
             "sluggishly. SDF and URDF want the tensor about the center of mass, and consumers "
             "move it from there themselves (parallel axes). CAD programs print both.",
      .what_to_do =
          "Take the tensor about the center of mass: from ixx subtract m (y² + z²), to ixy add m x "
          "y, and so on. `rigor inertia MODEL --write` computes it from the shapes.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_about_link_origin
