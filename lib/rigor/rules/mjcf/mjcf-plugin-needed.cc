// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_plugin_needed {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "plugin '" + fact.name + "' is not part of the MuJoCo library"});
}

Rule rule() {
  return {
      .name = "mjcf-plugin-needed",
      .severity = Severity::kInfo,
      .formats = Formats::kMjcf,
      .summary = "plugin that the MuJoCo library does not contain",
      .why = "MuJoCo rejects the model where no plugin library with that name was loaded "
             "before. Its Python package and its viewer load those that come with them "
             "(mujoco.elasticity, mujoco.sdf, mujoco.sensor, mujoco.pid); a program in C "
             "loads them with mj_loadPluginLibrary, and the JavaScript package has none.",
      .what_to_do = "Load the library of the plugin before the model.",
      .checks = {on_mjcf({read::MjcfFactKind::kPluginNeeded}, check)},
  };
}

}  // namespace rigor::rules::mjcf_plugin_needed
