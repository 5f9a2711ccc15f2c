// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/mjcf/space_around.h>
#include <rigor/rules/reference/nearest.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_class_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(with_nearest({.where = fact.where,
                               .message = "default class '" + fact.name + "' does not exist" +
                                          std::string(space_around(fact.name)),
                               .subject = fact.subject},
                              fact.name, fact.candidates, context));
}

Rule rule() {
  return {
      .name = "mjcf-class-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .fix = FixGrade::kUnsafe,
      .summary = "default class does not exist",
      .why = "MuJoCo rejects the file: an element or a childclass names a class that no <default> "
             "defines.",
      .what_to_do = "Write the name of a class that there is, or add a <default> with that class.",
      .checks = {on_mjcf({read::MjcfFactKind::kClassMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_class_missing
