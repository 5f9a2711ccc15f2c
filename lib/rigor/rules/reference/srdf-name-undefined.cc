// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::srdf_name_undefined {

using robot::SrdfFactKind;

void check(const model::Root&, Context& context) {
  report_srdf(context, {SrdfFactKind::kLinkUndefined, SrdfFactKind::kJointUndefined,
                        SrdfFactKind::kGroupUndefined});
}

Rule rule() {
  return {
      .name = "srdf-name-undefined",
      .severity = Severity::kError,
      .summary = "an SRDF refers to a link, joint or group that does not exist",
      .why = "MoveIt ignores the element with an error in its log: the group lacks the link"
             " or joint, and a pair of links that was to be left out is checked for "
             "collision again.",
      .what_to_do = "Write the name as the robot or the SRDF has it. `rigor edit rename` "
                    "renames in SRDF files as well.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::srdf_name_undefined
