// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::added_mass_negative {

void check(const model::Link& link, Context& context) {
  if (!link.inertial.added_mass) return;
  const auto& [xx, yy, zz, pp, qq, rr] = *link.inertial.added_mass;
  const std::pair<const char*, const model::Field<double>&> diagonal[] = {
      {"xx", xx}, {"yy", yy}, {"zz", zz}, {"pp", pp}, {"qq", qq}, {"rr", rr}};
  for (const auto& [name, number] : diagonal) {
    if (!(number.value < 0)) continue;
    const std::string text(read::trimmed(context.bytes(number.span)));
    context.report({.where = number.span,
                    .message = "the added mass " + std::string(name) + " is " + text +
                               ": water that has to be moved along makes a body heavier",
                    .subject = context.subject(link),
                    .help = "the plugins for hydrodynamics count it with the opposite sign"});
  }
}

Rule rule() {
  return {
      .name = "added-mass-negative",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "an added mass on the diagonal is negative",
      .why = "Gazebo adds the matrix to the body's own, so a negative entry makes the body "
             "lighter, and one that outweighs it makes the simulation diverge. Gazebo's "
             "hydrodynamics plugin takes the same coefficients as xDotU, where they are negative: "
             "they are easily copied as they are.",
      .what_to_do = "Write the entry without the minus sign.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::added_mass_negative
