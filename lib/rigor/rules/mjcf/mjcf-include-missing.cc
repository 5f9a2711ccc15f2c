// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/mjcf/space_around.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_include_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "included file '" + fact.name + "' does not exist" +
                             std::string(space_around(fact.name))});
}

Rule rule() {
  return {
      .name = "mjcf-include-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "included file does not exist",
      .why = "MuJoCo rejects the file. Paths are relative to the folder of the main file, also in "
             "files that are included.",
      .what_to_do = "Correct the path, or add the file.",
      .checks = {on_mjcf({read::MjcfFactKind::kIncludeMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_include_missing
