// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_mass_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("the body moves and lacks mass or inertia"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-mass-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "moving body without mass",
      .why = "MuJoCo rejects the file: mass and inertia of a body that moves must be above 1e-15. "
             "A body without <inertial> is weighed by its geoms, unless inertiafromgeom is false, "
             "their group is out of inertiagrouprange, or their mass or density is zero.",
      .what_to_do = "Add an <inertial>, or a geom that weighs.",
      .checks = {on_mjcf({read::MjcfFactKind::kMassMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_mass_missing
