// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_tendon_path {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = (fact.name.empty() ? "tendon" : "tendon '" + fact.name + "'") + ": " +
                             fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-tendon-path",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "tendon path leads nowhere",
      .why =
          "MuJoCo rejects the file: a spatial tendon goes through at least two sites, with each "
          "geom "
          "between two of them and no pulley at its end; a fixed one combines at least one joint.",
      .what_to_do = "Complete the path, or remove the tendon.",
      .checks = {on_mjcf({read::MjcfFactKind::kTendonPath}, check)},
  };
}

}  // namespace rigor::rules::mjcf_tendon_path
