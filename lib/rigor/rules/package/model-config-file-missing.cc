// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <utility>

#include <rigor/read/model_config.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_file_missing {

void check(const read::ConfigFact& fact, Context& context) {
  Finding finding{.where = fact.where, .message = "'" + fact.name + "' does not exist"};
  if (fact.name.empty()) finding.message = "<sdf> names no file";
  if (!fact.found.empty()) {
    finding.help = "there is '" + fact.found + "': names are case-sensitive";
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "model-config-file-missing",
      .severity = Severity::kError,
      .formats = Formats::kModelConfig,
      .summary = "a file in model.config does not exist",
      .why = "Including the folder fails: the file cannot be loaded.",
      .what_to_do = "Correct the name; it is relative to the folder of model.config.",
      .checks = {on_config({read::ConfigFactKind::kFileMissing}, check)},
  };
}

}  // namespace rigor::rules::model_config_file_missing
