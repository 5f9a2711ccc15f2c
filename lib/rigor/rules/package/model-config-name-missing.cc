// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/model_config.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::model_config_name_missing {

void check(const read::ConfigFact& fact, Context& context) {
  context.report({.where = fact.where, .message = "the model has no <name>"});
}

Rule rule() {
  return {
      .name = "model-config-name-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kModelConfig,
      .summary = "a model.config has no name",
      .why = "Gazebo shows the model under no name, and a Fuel server does not take it.",
      .what_to_do = "Write <name>, as a person would call the model.",
      .checks = {on_config({read::ConfigFactKind::kNameMissing}, check)},
  };
}

}  // namespace rigor::rules::model_config_name_missing
