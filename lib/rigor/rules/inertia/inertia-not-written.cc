// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::inertia_not_written {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!(inertial.mass.value > 0)) return;  // mass-negative and mass-zero report that
  if (!inertial.mass.written || inertial.tensor_written || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context)) return;
  if (misspelt_child(inertial.site, "inertia", context)) return;  // unknown-element
  context.report(
      {.where = inertial.site.name,
       .message = fmt::format(
           "the mass is {} kg, but there is no <inertia>: the moments are taken to be 1 kg·m²",
           inertial.mass.value),
       .subject = context.subject(link),
       .fix = fix_from_shapes(link, context),
       .cause = "no tensor"});
}

Rule rule() {
  return {
      .name = "inertia-not-written",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a mass is written without an inertia tensor",
      .why = "SDF then takes the identity as the tensor, whatever the mass: a wheel of 100 g has "
             "the inertia of a door.",
      .what_to_do = "`rigor inertia MODEL --write` computes the tensor that the mass has in the "
                    "link's shapes.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_not_written
