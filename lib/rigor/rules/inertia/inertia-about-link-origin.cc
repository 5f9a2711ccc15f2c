// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <fmt/core.h>

#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/inertia/write_tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_about_link_origin {

/// The products that m has at p about another point.
model::Vector3 products(const mass::Inertia& tensor) {
  return {tensor.ixy, tensor.ixz, tensor.iyz};
}

/// The tensor about the center of mass, if the written one is about the link's origin by itself: its products are
/// those of the mass at its center. A rod from the origin has a third of them about its center, not all.
std::optional<mass::Inertia> about_center(const model::Inertial& inertial) {
  constexpr double kParallel = 0.95;  // cosine
  constexpr double kAtLeast = 0.8;    // of the products of the mass at its center
  constexpr double kAtMost = 1.7;     // with the body's own
  constexpr double kMinShare = 0.05;  // of the moments' sum: less may be chance
  const double mass = inertial.mass.value;
  const model::Pose& X_LC = inertial.pose.pose.value;
  if (X_LC.rotation != model::Quaternion{}) return std::nullopt;
  const mass::Inertia written = mass::tensor(inertial);
  const mass::Inertia moved = mass::point_inertia(mass, X_LC.translation);
  const model::Vector3 own = products(written), expected = products(moved);
  const double size = length(expected);
  if (size < kMinShare * mass::trace(written)) return std::nullopt;
  if (dot(own, expected) < kParallel * length(own) * size) return std::nullopt;
  const double share = length(own) / size;
  if (share < kAtLeast || share > kAtMost) return std::nullopt;
  const mass::Inertia about_com = written - moved;
  if (!mass::judge(mass, about_com).possible()) return std::nullopt;
  return about_com;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  const model::Pose& X_LC = inertial.pose.pose.value;
  if (X_LC.translation == model::Vector3{}) return;
  const MistakenTensor mistaken = mistaken_tensor(link, context);
  const bool by_shapes = mistaken.mistake == TensorMistake::kAboutLinkOrigin;
  const double distance = model::length(X_LC.translation);
  if (by_shapes) {
    context.report(
        {.where = inertial.tensor_site.name,
         .message = fmt::format(
             "the tensor is what the link's shapes have about the link's origin, {:.3g} m "
             "from the center of mass: {} kg at that distance are counted twice",
             distance, inertial.mass.value),
         .subject = context.subject(link),
         .fix = write_tensor(inertial, without_mass_at_center(inertial))});
    return;
  }
  if (mistaken.mistake != TensorMistake::kNone || !has_tensor(link, context)) return;
  if (!is_dynamic(link, context) || !(inertial.mass.value > 0)) return;
  if (!context.verdict(link).possible()) return;
  const auto about_com = about_center(inertial);
  if (!about_com) return;
  context.report({.where = inertial.tensor_site.name,
                  .message = fmt::format(
                      "the products of inertia are close to those of {} kg at the center of mass, "
                      "{:.3g} m away: the tensor looks as if it were about the link's "
                      "origin",
                      inertial.mass.value, distance),
                  .subject = context.subject(link),
                  .fix = write_tensor(inertial, *about_com),
                  .severity = Severity::kInfo});
}

Rule rule() {
  return {
      .name = "inertia-about-link-origin",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an inertia tensor is about the link's origin instead of the center of mass",
      .why = "A tensor about the origin of the link is moved twice, so that the link rotates too "
             "sluggishly. SDF and URDF want the tensor about the center of mass, and consumers "
             "move it from there themselves (parallel axes). CAD programs print both. Where "
             "the shapes do not tell, products that are those of the mass at its center are an "
             "info.",
      .what_to_do =
          "Take the tensor about the center of mass: from ixx subtract m (y² + z²), to ixy add m x "
          "y, and so on. `rigor inertia MODEL --write` computes it from the shapes.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_about_link_origin
