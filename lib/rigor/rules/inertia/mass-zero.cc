// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/rigid_groups.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

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

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.mass.written || inertial.mass.value != 0 || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context)) return;
  // In URDF a link of no mass and no moments is a frame, as one without <inertial> is.
  if (context.is_urdf() && is_zero(mass::tensor(inertial))) return;
  if (is_lumped(link, context)) return;
  context.report({.where = inertial.mass.span,
                  .message = "the mass is 0 kg: a body that moves needs one above zero",
                  .subject = context.subject(link),
                  .fix = fix_from_shapes(link, context)});
}

Rule rule() {
  return {
      .name = "mass-zero",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link that moves has a mass of zero",
      .why = "libsdformat lets it pass, and the physics engine then divides by it: ODE stops at an "
             "assertion, DART sets a tiny mass of its own. A URDF link of no mass but with moments "
             "is dropped by Gazebo, unless it is fixed to one that has mass.",
      .what_to_do = "Write the mass, however small. For a frame without a body take the <inertial> "
                    "out of a URDF link, or use <frame> in SDF.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_zero
