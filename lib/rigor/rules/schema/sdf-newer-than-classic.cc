// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::sdf_newer_than_classic {

constexpr int kNewestOfClassic = 7;

void check(const model::Root& root, Context& context) {
  if (root.version <= kNewestOfClassic || !root.version_text.written) return;
  context.report({.where = root.version_text.span,
                  .message = "Gazebo classic reads SDF up to 1.7, and this file is SDF " +
                             root.version_text.value});
}

Rule rule() {
  return {
      .name = "sdf-newer-than-classic",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kGazeboClassic},
      .summary = "a file is newer than what Gazebo classic reads",
      .why = "Gazebo 11, the last Gazebo classic, reads by libsdformat 9, which knows SDF up to "
             "1.7. It says that it is unable to convert the version, and what came later has no "
             "effect, if the model is loaded at all.",
      .what_to_do = "Write version=\"1.7\" when the file uses nothing newer "
                    "(element-newer-than-classic names what is), or keep a file for each simulator "
                    "and name both in model.config: each takes the newest that it can read.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sdf_newer_than_classic
