// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>

namespace rigor::rules::inertia_identity {

// Without shapes to compare with: a ball with these moments and this mass is a meter across.
constexpr double kLight = 10;  // kg

// A body whose shapes have the moments of the identity up to this factor may have been computed.
constexpr double kFits = 1.25;

void check(const model::Link& link, Context& context) {
  constexpr mass::Inertia kIdentity{1, 0, 0, 1, 0, 1};
  if (!has_tensor(link, context) || mass::tensor(link.inertial) != kIdentity) return;
  const double mass = link.inertial.mass.value;
  if (!(mass > 0) || !is_dynamic(link, context)) return;
  const auto share = share_of_solid(link, mass, kIdentity, context);
  // Nothing is known of a body without shapes of exactly 1 kg, as tests have it.
  if (share ? *share<kFits&& * share> 1 / kFits : mass > kLight || mass == 1) return;
  const bool may_fit = share && plausible(*share);
  std::string message = fmt::format("the moments of a body of {} kg are all 1 kg·m²", mass);
  if (share) message += fmt::format(": {:.4g} times what its shapes have as solids", *share);
  context.report(
      {.where = link.inertial.tensor_site.name,
       .message = std::move(message),
       .subject = context.subject(link),
       .fix = may_fit ? std::nullopt : fix_from_shapes(link, context),
       .cause = "placeholder 1",
       .severity = may_fit || is_for_bullet(context) ? Severity::kInfo : Severity::kWarning});
}

Rule rule() {
  return {
      .name = "inertia-identity",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "inertia tensor is the identity",
      .why = "The link rotates far too slowly or too fast, and controllers are tuned to that. "
             "Ones on the diagonal are the placeholder of templates. Where the body may have such "
             "moments, up to a factor of ten, it is an info.",
      .what_to_do = "`rigor inertia MODEL --write` computes the moments that the mass has in the "
                    "link's shapes.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_identity
