// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::srdf_adjacent_pair_checked {

using robot::SrdfFactKind;

void check(const model::Root&, Context& context) {
  report_srdf(context, {SrdfFactKind::kPairsChecked});
}

Rule rule() {
  return {
      .name = "srdf-adjacent-pair-checked",
      .severity = Severity::kWarning,
      .summary = "links that a joint connects are checked for collision",
      .why = "Neighbors often touch where the joint is. MoveIt then reports a collision in every "
             "state and plans nothing. Only an SRDF that has a collision matrix is checked.",
      .what_to_do = "`rigor srdf ROBOT --update FILE --write` adds the pairs that are "
                    "missing; or write <disable_collisions link1=\"…\" link2=\"…\" "
                    "reason=\"Adjacent\"/>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::srdf_adjacent_pair_checked
