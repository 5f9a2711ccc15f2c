// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::density_not_positive {

void look_at(const model::Field<double>& density, const std::string& subject, Context& context) {
  if (!density.written || density.value > 0) return;
  context.report(
      {.where = density.span,
       .message = fmt::format("the density is {} kg/m³: it must be above zero", density.value),
       .subject = subject});
}

void check(const model::Link& link, Context& context) {
  if (!is_computed(link, context)) return;
  look_at(link.inertial.density, context.subject(link), context);
  for (const auto id : link.collisions) {
    const model::Collision& collision = context.root()[id];
    look_at(collision.density, context.subject(collision), context);
  }
}

Rule rule() {
  return {
      .name = "density-not-positive",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "an automatic inertial is computed with a density that is not above zero",
      .why = "The mass of such a shape would be zero or negative. libsdformat 14 and later cannot "
             "compute the inertial and refuse the link.",
      .what_to_do = "Write the density in kg/m³: water has 1000, steel 7850.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::density_not_positive
