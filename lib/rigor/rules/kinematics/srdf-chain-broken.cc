// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::srdf_chain_broken {

using robot::SrdfFactKind;

void check(const model::Root&, Context& context) {
  report_srdf(context, {SrdfFactKind::kChainEmpty, SrdfFactKind::kChainBroken});
}

Rule rule() {
  return {
      .name = "srdf-chain-broken",
      .severity = Severity::kError,
      .summary = "a chain's tip is not below its base",
      .why = "The links from base to tip are followed up through the parents of joints. "
             "MoveIt takes what it finds for a group that is no chain: inverse kinematics "
             "refuses it, or the group has no joints at all.",
      .what_to_do = "Swap base_link and tip_link, or name a base that carries the tip.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::srdf_chain_broken
