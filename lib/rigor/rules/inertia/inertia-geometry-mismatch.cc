// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/slip.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_geometry_mismatch {

// Less is a token for a frame that had to have some mass.
constexpr double kLeast = 1e-3;  // kg

void check(const model::Link& link, Context& context) {
  constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};  // inertia-identity speaks of that
  const double mass = link.inertial.mass.value;
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return;
  if (!link.inertial.mass.written || mass <= kLeast) return;
  const mass::Inertia tensor = mass::tensor(link.inertial);
  if (!context.verdict(link).possible() || mass::trace(tensor) == 0 || tensor == kIdentity) return;
  const auto share = share_of_solid(link, mass, tensor, context);
  if (!share || plausible(*share)) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kNone) return;  // told there
  const double solid = mass::trace(tensor) / *share;
  const double factor = std::max(*share, 1 / *share);
  context.report({.where = link.inertial.tensor_site.name,
                  .message = fmt::format(
                      "ixx + iyy + izz is {:.4g} kg·m², {:.4g} times {} than the {:.4g} "
                      "kg·m² of its shapes as solids of {} kg",
                      mass::trace(tensor), factor, *share > 1 ? "more" : "less", solid, mass),
                  .subject = context.subject(link),
                  .help = guess_slip(*share),
                  .fix = fix_from_shapes(link, context)});
}

Rule rule() {
  return {
      .name = "inertia-geometry-mismatch",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "moments of inertia do not fit the mass and the shapes of the link",
      .why = "The link's shapes are all boxes, balls, closed meshes and the like, so what a solid "
             "of the same mass has is known. Hollow bodies have up to three times as much; a "
             "factor of ten and more is mostly a slip of units. Too small moments make a "
             "simulation shake, too large ones make it sluggish.",
      .what_to_do = "`rigor inertia MODEL` shows what the mass has in the link's shapes, in kg·m², "
                    "and writes it with --write.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_geometry_mismatch
