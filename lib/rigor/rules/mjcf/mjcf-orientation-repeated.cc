// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_orientation_repeated {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = std::string("the orientation is written in more than one way"),
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-orientation-repeated",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "orientation is written twice",
      .why = "MuJoCo rejects the file: of quat, axisangle, xyaxes, zaxis and euler an element has "
             "one at most. Versions of before 3 take a quat beside another.",
      .what_to_do = "Keep the one that is meant.",
      .checks = {on_mjcf({read::MjcfFactKind::kOrientationTwice}, check)},
  };
}

}  // namespace rigor::rules::mjcf_orientation_repeated
