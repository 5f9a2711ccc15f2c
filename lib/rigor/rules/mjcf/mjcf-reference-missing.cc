// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/mjcf/space_around.h>
#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_reference_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(with_nearest({.where = fact.where,
                               .message = fact.detail + " '" + fact.name + "' does not exist" +
                                          std::string(space_around(fact.name)),
                               .subject = fact.subject},
                              fact.name, fact.candidates, context));
}

Rule rule() {
  return {
      .name = "mjcf-reference-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .fix = FixGrade::kUnsafe,
      .summary = "reference to a name that does not exist",
      .why = "MuJoCo rejects the file: a joint, body, site, mesh, material or other element is "
             "named that the model does not have.",
      .what_to_do = "Write the name of an element that there is, or add it.",
      .checks = {on_mjcf({read::MjcfFactKind::kReferenceMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_reference_missing
