// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/model_config.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_version_missing {

void check(const read::ConfigFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = "'" + fact.name + "' is named without its version"});
}

Rule rule() {
  return {
      .name = "model-config-version-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kModelConfig,
      .summary = "a file in model.config has no SDF version",
      .why = "libsdformat chooses the file by it, and warns.",
      .what_to_do =
          "Write the version that the file has, as in <sdf version=\"1.9\">model.sdf</sdf>.",
      .checks = {on_config({read::ConfigFactKind::kVersionMissing}, check)},
  };
}

}  // namespace rigor::rules::model_config_version_missing
