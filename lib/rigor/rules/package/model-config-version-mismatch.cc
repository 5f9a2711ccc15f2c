// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/model_config.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_version_mismatch {

void check(const read::ConfigFact& fact, Context& context) {
  // Of several files, the one that is said to have the highest version is the model.
  const auto how = fact.of_several ? Applicability::kUnsafe : Applicability::kSafe;
  context.report({.where = fact.where,
                  .message = "the file is SDF " + fact.found + ", not " + fact.name,
                  .fix = Fix{"write " + fact.found, how, {{fact.where, fact.found}}}});
}

Rule rule() {
  return {
      .name = "model-config-version-mismatch",
      .severity = Severity::kWarning,
      .formats = Formats::kModelConfig,
      .fix = FixGrade::kSafe,
      .summary = "the version in model.config differs from that of the file",
      .why = "libsdformat chooses among several files by the versions in model.config, and reads "
             "the file by its own version.",
      .what_to_do = "Write the version that the file has.",
      .checks = {on_config({read::ConfigFactKind::kVersionMismatch}, check)},
  };
}

}  // namespace rigor::rules::model_config_version_mismatch
