// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_keyframe_short {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.name + " has " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-keyframe-short",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "keyframe with too few numbers",
      .why = "MuJoCo before 3.3 rejects the file; newer versions fill the rest with the state at "
             "rest, of controls with zeros.",
      .what_to_do = "Write as many numbers as the model has.",
      .checks = {on_mjcf({read::MjcfFactKind::kKeyframeShort}, check)},
  };
}

}  // namespace rigor::rules::mjcf_keyframe_short
