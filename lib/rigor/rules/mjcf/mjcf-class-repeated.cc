// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_class_repeated {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "default class '" + fact.name + "' is defined twice",
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-class-repeated",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "default class is defined twice",
      .why = "MuJoCo rejects the file: names of default classes are unique.",
      .what_to_do = "Rename one of the classes, or put the defaults of both into one.",
      .checks = {on_mjcf({read::MjcfFactKind::kClassRepeated}, check)},
  };
}

}  // namespace rigor::rules::mjcf_class_repeated
