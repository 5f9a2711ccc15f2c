// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_part_alone {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "no " + fact.detail + " is called '" + fact.name +
                             "': the file has no <worldbody>",
                  .help = "check the file that includes it, and use <mujocoinclude> as its root"});
}

Rule rule() {
  return {
      .name = "mjcf-part-alone",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "part of a model with the root of a whole one",
      .why = "MuJoCo rejects the file as a model: what it refers to is in a file that "
             "includes it. With <mujocoinclude> as its root element it says so itself, and "
             "rigor checks it with the file that includes it.",
      .what_to_do = "Rename the root element to <mujocoinclude>; MuJoCo includes it as before.",
      .checks = {on_mjcf({read::MjcfFactKind::kPartAlone}, check)},
  };
}

}  // namespace rigor::rules::mjcf_part_alone
