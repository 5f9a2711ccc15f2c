// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_not_expanded {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "<" + fact.name + "> is not expanded: its bodies are not checked"});
}

Rule rule() {
  return {
      .name = "mjcf-not-expanded",
      .severity = Severity::kInfo,
      .formats = Formats::kMjcf,
      .summary = "recipe that rigor does not expand",
      .why = "MuJoCo makes bodies, joints and geoms from <composite> and <flexcomp>. rigor reads "
             "the rest of the model; what these bring is neither counted, weighed nor drawn.",
      .what_to_do = "Nothing is wrong with the file. To check what MuJoCo makes of it, save the "
                    "compiled model and check that.",
      .checks = {on_mjcf({read::MjcfFactKind::kNotExpanded}, check)},
  };
}

}  // namespace rigor::rules::mjcf_not_expanded
