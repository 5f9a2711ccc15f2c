// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_keyframe_implausible {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.detail, .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-keyframe-implausible",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "keyframe with positions that the joints cannot have",
      .why = "MuJoCo loads the keyframe: the limit of the joint pushes it back with a "
             "jerk, and a quaternion of zero becomes no rotation.",
      .what_to_do = "Write positions within the ranges, in radians and meters, and unit "
                    "quaternions.",
      .checks = {on_mjcf({read::MjcfFactKind::kKeyframeState}, check)},
  };
}

}  // namespace rigor::rules::mjcf_keyframe_implausible
