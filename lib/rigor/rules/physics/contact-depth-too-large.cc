// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <variant>

#include <fmt/core.h>

#include <rigor/rules/physics/contact_settings.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::contact_depth_too_large {

// Of the thinnest side: the body is seen to stand in the ground.
constexpr double kMax = 0.25;

// A few millimeters are usual, however thin the sheet is.
constexpr double kUsual = 5e-3;  // m

/// The thinnest side of a plain shape, m.
std::optional<double> thickness(const model::Shape& shape) {
  if (const auto* box = std::get_if<model::Box>(&shape)) {
    const model::Vector3& size = box->size.value;
    return std::min({size.x, size.y, size.z});
  }
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return 2 * ball->radius.value;
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) {
    return std::min(2 * cylinder->radius.value, cylinder->length.value);
  }
  if (const auto* capsule = std::get_if<model::Capsule>(&shape)) return 2 * capsule->radius.value;
  return std::nullopt;
}

// m; whatever the shape, no wheel or foot is to sink in as far.
constexpr double kEver = 0.1;

void check_collision(const model::Collision& collision, Context& context) {
  const auto thick = thickness(collision.geometry.shape);
  if (!thick || !(*thick > 0)) return;
  const auto& depth = collision.surface.min_depth;
  if (!depth.written || depth.value <= std::max(kUsual, kMax * *thick)) return;
  context.report({.where = depth.span,
                  .message = fmt::format("bodies may sink {} m into each other before anything "
                                         "pushes them apart, and this one is {:.3g} m thick",
                                         depth.value, *thick),
                  .subject = context.subject(collision)});
}

/// Of meshes, and of links of a URDF: no thickness is known.
void check(const model::Root& root, Context& context) {
  for (const model::Collision& collision : root.collisions) {
    if (context.is_sdf() && root.own(collision.site)) check_collision(collision, context);
  }
  for (const ContactSettings& contact : contact_settings(context)) {
    if (!contact.min_depth.written || !(contact.min_depth.value >= kEver)) continue;
    if (contact.collision != nullptr && thickness(contact.collision->geometry.shape)) continue;
    context.report({.where = contact.min_depth.span,
                    .message = fmt::format("bodies may sink {} m into each other before anything "
                                           "pushes them apart",
                                           contact.min_depth.value),
                    .subject = contact.subject});
  }
}

Rule rule() {
  return {
      .name = "contact-depth-too-large",
      .severity = Severity::kWarning,
      .summary = "the depth that contacts leave uncorrected is a large part of the shape",
      .why = "Gazebo classic corrects a penetration only beyond min_depth (meters). The body "
             "sinks in by that much, and a wheel rolls with a smaller radius than it has.",
      .what_to_do = "Write a millimeter or less, in meters.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::contact_depth_too_large
