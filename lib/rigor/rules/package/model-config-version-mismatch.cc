// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>

#include <rigor/read/model_config.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_version_mismatch {

/// Of several files, the one that is said to have the highest version is the model.
Applicability fix_of_version(const Context& context) {
  const auto top = context.document().root();
  if (!top) return Applicability::kUnsafe;
  std::size_t count = 0;
  for (const xml::Element child : top->children()) count += child.name() == "sdf" ? 1 : 0;
  return count == 1 ? Applicability::kSafe : Applicability::kUnsafe;
}

void check(const read::ConfigFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "the file is SDF " + fact.found + ", not " + fact.name,
       .fix = Fix{"write " + fact.found, fix_of_version(context), {{fact.where, fact.found}}}});
}

Rule rule() {
  return {
      .name = "model-config-version-mismatch",
      .severity = Severity::kWarning,
      .formats = Formats::kModelConfig,
      .fix = FixGrade::kSafe,
      .summary = "a file in model.config has another version than is said",
      .why = "libsdformat chooses among several files by what model.config says, and reads the "
             "file by what the file says.",
      .what_to_do = "Write the version that the file has.",
      .checks = {on_config({read::ConfigFactKind::kVersionMismatch}, check)},
  };
}

}  // namespace rigor::rules::model_config_version_mismatch
