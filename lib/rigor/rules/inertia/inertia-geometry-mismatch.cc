// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/moment_slips.h>
#include <rigor/rules/inertia/slip.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>

namespace rigor::rules::inertia_geometry_mismatch {

// Less is a token for a frame that had to have some mass.
constexpr double kMin = 1e-3;  // kg

/// Whether the moments are what a template holds: zeros and one power of ten.
bool is_placeholder(const mass::Inertia& tensor) {
  double power = 0;
  for (const double moment : {tensor.ixx, tensor.iyy, tensor.izz}) {
    if (moment == 0) continue;
    const double exponent = std::round(std::log10(moment));
    if (std::abs(moment - std::pow(10, exponent)) > 1e-9 * moment) return false;
    if (power != 0 && power != moment) return false;
    power = moment;
  }
  return true;
}

/// The slip of a unit that explains the share; null without one.
const MomentSlip* slip_of(const model::Link& link, double share, Context& context) {
  if (is_placeholder(mass::tensor(link.inertial))) return nullptr;
  auto solid = solid_of_all(link, mass::From::kCollisions, context);
  if (!solid) solid = solid_of_all(link, mass::From::kVisuals, context);
  return slip_of_share(share, solid ? link.inertial.mass.value / solid->mass : 0);
}

const char* help_for(const mass::Inertia& tensor, double share, const MomentSlip* slip) {
  if (is_placeholder(tensor)) {
    return "the moments look like a placeholder: compute them from the body's mass and size";
  }
  return slip != nullptr ? slip->help : guess_slip(share);
}

void check(const model::Link& link, Context& context) {
  constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};  // inertia-identity reports that
  const double mass = link.inertial.mass.value;
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return;
  if (!link.inertial.mass.written || mass <= kMin) return;
  const mass::Inertia tensor = mass::tensor(link.inertial);
  if (!context.verdict(link).possible() || mass::trace(tensor) == 0 || tensor == kIdentity) return;
  const auto share = share_of_solid(link, mass, tensor, context);
  if (!share || plausible(*share)) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kNone) return;  // reported there
  const double solid = mass::trace(tensor) / *share;
  const double factor = std::max(*share, 1 / *share);
  const MomentSlip* slip = slip_of(link, *share, context);
  // One placeholder is one finding, whatever the masses that it was given to.
  std::string cause;
  if (is_placeholder(tensor)) {
    cause = fmt::format("placeholder {}, {}", std::max({tensor.ixx, tensor.iyy, tensor.izz}),
                        *share > 1 ? "more" : "less");
  }
  context.report({.where = link.inertial.tensor_site.name,
                  .message = fmt::format(
                      "ixx + iyy + izz is {:.4g} kg·m², {:.4g} times {} than the {:.4g} "
                      "kg·m² of its shapes as solids of {} kg",
                      mass::trace(tensor), factor, *share > 1 ? "more" : "less", solid, mass),
                  .subject = context.subject(link),
                  .help = help_for(tensor, *share, slip),
                  // Moments in another unit keep their digits; others are computed from the shapes.
                  .fix = slip ? undo(*slip, link.inertial) : fix_from_shapes(link, context),
                  .cause = std::move(cause),
                  .why = *share > 1 ? "The link rotates as sluggishly as a much larger or heavier "
                                      "body would."
                                    : "Joints with such small moments make a simulation unstable.",
                  .severity = is_for_bullet(context) ? Severity::kInfo : Severity::kWarning});
}

Rule rule() {
  return {
      .name = "inertia-geometry-mismatch",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "moments of inertia do not fit the mass and the shapes of the link",
      .why = "Moments that are too small make a simulation unstable, those that are too large make "
             "it sluggish. The link's shapes are all boxes, spheres, closed meshes and the like, "
             "so the moments of a solid of the same mass are known. Hollow bodies have up to three "
             "times as much; "
             "a factor of ten and more is mostly an error of units. Bullet "
             "computes tensors from the collisions: in a model with Bullet's own elements this is "
             "an info.",
      .what_to_do = "`rigor inertia MODEL` shows the moments of the link's shapes in kg·m², and "
                    "writes them with --write.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_geometry_mismatch
