// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_include_broken {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = "included file '" + fact.name + "' " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-include-broken",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "included file cannot be read",
      .why = "MuJoCo rejects the whole model: an included file has to be well-formed XML.",
      .what_to_do = "Repair the included file; rigor validate names what is wrong with it.",
      .checks = {on_mjcf({read::MjcfFactKind::kIncludeBroken}, check)},
  };
}

}  // namespace rigor::rules::mjcf_include_broken
