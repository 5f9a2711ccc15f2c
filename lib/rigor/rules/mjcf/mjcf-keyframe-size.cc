// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_keyframe_size {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where, .message = fact.name + " has " + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-keyframe-size",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "keyframe of the wrong size",
      .why = "MuJoCo rejects the file: qpos has 7 numbers for a free joint, 4 for a ball and 1 for "
             "a hinge or slide; qvel 6, 3 and 1; ctrl one for each actuator; mpos 3 and mquat 4 "
             "for each mocap body.",
      .what_to_do = "Write as many numbers as the model has.",
      .checks = {on_mjcf({read::MjcfFactKind::kKeyframeSize}, check)},
  };
}

}  // namespace rigor::rules::mjcf_keyframe_size
