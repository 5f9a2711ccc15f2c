// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <variant>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/rigid_groups.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>

namespace rigor::rules::mass_zero {

bool is_zero(const mass::Inertia& tensor) { return tensor == mass::Inertia{}; }

/// Whether Gazebo's converter makes it one body with a link that has mass.
bool is_lumped(const model::Link& link, const Context& context) {
  if (!context.is_urdf()) return false;
  const model::Root& root = context.root();
  const RigidGroups groups(context);
  const std::uint32_t own = groups.of({static_cast<std::uint32_t>(&link - root.links.data())});
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    if (groups.of({i}) == own && root.links[i].inertial.mass.value > 0) return true;
  }
  return false;
}

/// A plane has no mass: without one it does not move.
bool is_ground(const model::Link& link, const Context& context) {
  return std::any_of(link.collisions.begin(), link.collisions.end(), [&](const auto id) {
    return std::holds_alternative<model::Plane>(context.root()[id].geometry.shape);
  });
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.mass.written || inertial.mass.value != 0 || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context) || is_ground(link, context)) return;
  // In URDF a link of no mass and no moments is a frame, as one without <inertial> is.
  if (context.is_urdf() && is_zero(mass::tensor(inertial))) return;
  const bool lumped = is_lumped(link, context);
  context.report(
      {.where = inertial.mass.span,
       .message = lumped ? "the mass is 0 kg, but the inertia tensor is not zero"
                         : "the mass is 0 kg: a body that moves needs one above zero",
       .subject = context.subject(link),
       .fix = lumped ? std::nullopt : fix_from_shapes(link, context),
       .why = lumped ? "libsdformat adds the moments alone to the link that this one is fixed to."
                     : "",
       .severity = lumped || is_for_bullet(context) ? Severity::kInfo : Severity::kWarning});
}

Rule rule() {
  return {
      .name = "mass-zero",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link that moves has a mass of zero",
      .why = "libsdformat accepts it, and the physics engine then divides by it: ODE stops at an "
             "assertion, DART warns of a crash or of wrong motion. Gazebo drops a URDF link "
             "without mass, with its moments, unless it is fixed to a link that has mass: then "
             "the moments alone are added, which is an info. Bullet fixes such a link in place, "
             "so that in a model with Bullet's own elements it is an info, too.",
      .what_to_do = "Write the mass, however small. For a frame without a body remove the "
                    "<inertial> of a URDF link, or use <frame> in SDF.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_zero
