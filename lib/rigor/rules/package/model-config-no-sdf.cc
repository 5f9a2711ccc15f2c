// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/read/fact.h>
#include <rigor/read/model_config.h>
#include <rigor/rules/rule.h>
#include <rigor/text/disk.h>

namespace rigor::rules::model_config_no_sdf {

/// A folder of meshes that other models use has a model.config so that model:// leads there, and
/// no file includes it.
bool holds_a_model(const Context& context) {
  for (const std::string& name : context.disk().list(std::string(context.folder()))) {
    const std::string_view file = name;
    if (file.ends_with(".sdf") || file.ends_with(".urdf") || file.ends_with(".xacro")) return true;
  }
  return false;
}

void check(const read::ConfigFact& fact, Context& context) {
  if (!holds_a_model(context)) return;
  context.report({.where = fact.where, .message = "no <sdf> names the file to load"});
}

/// Of a folder that the file includes.
void check_included(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the folder of this model cannot be loaded: " + fact.name +
                             " is missing, or names no SDF file"});
}

Rule rule() {
  return {
      .name = "model-config-no-sdf",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a model.config names no SDF file",
      .why = "Including the folder is an error: there is nothing to load. Of a folder without a "
             "model, as one of meshes that others use, that is reported only where it is included.",
      .what_to_do = "Write the file to load, as in <sdf version=\"1.9\">model.sdf</sdf>.",
      .checks = {on_config({read::ConfigFactKind::kNoSdf}, check),
                 on_read({read::FactKind::kConfigWithoutSdf}, check_included)},
  };
}

}  // namespace rigor::rules::model_config_no_sdf
