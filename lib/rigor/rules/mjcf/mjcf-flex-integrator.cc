// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_flex_integrator {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "a flex with " + fact.detail + " cannot be integrated by '" + fact.name + "'",
       .related = fact.related.nowhere() ? std::vector<Label>{}
                                         : std::vector<Label>{{fact.related, "the integrator"}}});
}

Rule rule() {
  return {
      .name = "mjcf-flex-integrator",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "soft flex and an integrator that does not take it",
      .why = "MuJoCo 3.14 rejects the model: the elasticity of a solid flex, or of a shell "
             "with elastic2d, is no longer integrated by implicit and implicitfast, and "
             "passive contact needs the integrator discrete. Older versions take it.",
      .what_to_do = "Set integrator=\"discrete\" in <option>.",
      .checks = {on_mjcf({read::MjcfFactKind::kFlexIntegrator}, check)},
  };
}

}  // namespace rigor::rules::mjcf_flex_integrator
