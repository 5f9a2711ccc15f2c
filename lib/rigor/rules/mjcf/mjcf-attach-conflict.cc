// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_attach_conflict {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = fact.detail + ", and conflict=\"" + fact.name + '"'});
}

Rule rule() {
  return {
      .name = "mjcf-attach-conflict",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "options of an attached model conflict",
      .why = "MuJoCo rejects the model: with conflict=\"error\" an attached file may set no "
             "option otherwise than the one that attaches it, and conflict=\"merge\" joins "
             "only those with a smaller or larger value that suits both, not gravity, "
             "integrator, cone, solver and their like.",
      .what_to_do = "Set the option in one of the files only, or to the same value in both; or use "
                    "conflict=\"warning\", which keeps the value of the attaching file.",
      .checks = {on_mjcf({read::MjcfFactKind::kAttachConflict}, check)},
  };
}

}  // namespace rigor::rules::mjcf_attach_conflict
