// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_placeholder {

enum class Origin : std::uint8_t { kNone, kPlaceholder, kComputed };

/// A template has one power of ten on the diagonal, and a body that is computed some other number.
Origin origin_of(const model::Link& link, const Context& context) {
  if (!has_tensor(link, context) || !is_dynamic(link, context)) return Origin::kNone;
  const mass::Inertia t = mass::tensor(link.inertial);
  if (!(t.ixx > 0) || t == mass::Inertia{1, 0, 0, 1, 0, 1}) return Origin::kNone;
  const double power = std::pow(10, std::round(std::log10(t.ixx)));
  const mass::Inertia round{power, 0, 0, power, 0, power};
  const mass::Inertia off = t - round;
  const double most = std::abs(off.ixx) + std::abs(off.iyy) + std::abs(off.izz) +
                      std::abs(off.ixy) + std::abs(off.ixz) + std::abs(off.iyz);
  return most < 1e-6 * power ? Origin::kPlaceholder : Origin::kComputed;
}

/// Whether the shapes have about these moments all the same.
bool fits_shapes(const model::Link& link, Context& context) {
  constexpr double kFits = 2;
  const double mass = link.inertial.mass.value;
  const auto share = share_of_solid(link, mass, mass::tensor(link.inertial), context);
  return share && *share<kFits&& * share> 1 / kFits;
}

void check(const model::Model& model, Context& context) {
  constexpr double kMin = 0.05;      // kg; less is a token for a frame that had to have some mass
  constexpr std::size_t kShare = 3;  // of computed tensors, for each placeholder
  const model::Root& root = context.root();
  std::size_t computed = 0;
  std::vector<const model::Link*> found;
  for (const auto id : model.links) {
    const Origin origin = origin_of(root[id], context);
    computed += origin == Origin::kComputed;
    if (origin == Origin::kPlaceholder && root[id].inertial.mass.value > kMin)
      found.push_back(&root[id]);
  }
  if (computed < kShare * found.size()) return;
  for (const model::Link* link : found) {
    if (!root.own(link->site) || fits_shapes(*link, context)) continue;
    context.report(
        {.where = link->inertial.tensor_site.name,
         .message = fmt::format("the moments of a body of {:.4g} kg are all {:g} kg·m²: a "
                                "template's, while those of {} other links are computed",
                                link->inertial.mass.value, link->inertial.ixx.value, computed),
         .subject = context.subject(*link),
         .fix = fix_from_shapes(*link, context)});
  }
}

Rule rule() {
  return {
      .name = "inertia-placeholder",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a link has a template's tensor, and the robot's other links have computed ones",
      .why = "The link rotates too slowly or too fast for its mass. One power of ten on the "
             "diagonal is what templates hold; no body of that mass was computed so, unless its "
             "shapes have about these moments.",
      .what_to_do = "`rigor inertia MODEL --write` computes the moments that the mass has in the "
                    "link's shapes.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::inertia_placeholder
