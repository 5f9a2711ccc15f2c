// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_mocap_not_static {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the body cannot be a mocap body: " + fact.detail,
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-mocap-not-static",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "mocap body that is not a fixed child of the world",
      .why = "MuJoCo rejects the file: a mocap body is a child of the world and has no joints.",
      .what_to_do = "Move the body to the top level and remove its joints, or remove mocap.",
      .checks = {on_mjcf({read::MjcfFactKind::kMocapNotStatic}, check)},
  };
}

}  // namespace rigor::rules::mjcf_mocap_not_static
