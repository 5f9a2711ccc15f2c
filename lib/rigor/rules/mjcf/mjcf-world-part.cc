// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_world_part {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "<" + fact.name + "> is in the world, which does not move",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-world-part",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "joint or inertial of the world",
      .why = "MuJoCo rejects the file: the world has no joints and no inertia, neither in "
             "<worldbody> nor in its frames.",
      .what_to_do = "Move it into the body that it is of.",
      .checks = {on_mjcf({read::MjcfFactKind::kWorldPart}, check)},
  };
}

}  // namespace rigor::rules::mjcf_world_part
