// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::xacro_not_installed {

void check(const read::Fact&, Context& context) {
  context.report({.message = "xacro is not installed, so the file was not looked at"});
}

// A test shows it, which takes the program away; no example can.
Rule rule() {
  return {
      .name = "xacro-not-installed",
      .severity = Severity::kInfo,
      .summary = "a .xacro file was not looked at, since xacro is not installed",
      .why = "What a .xacro file means is known once the program xacro has expanded its macros, as "
             "launch files do before anything reads the robot. Without it nothing is known of the "
             "file.",
      .what_to_do = "Install xacro (ros-DISTRO-xacro, or xacro from PyPI) and have it in PATH, or "
                    "expand the file yourself and check what comes out.",
      .checks = {on_read({read::FactKind::kXacroMissing}, check)},
  };
}

}  // namespace rigor::rules::xacro_not_installed
