// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_outside_roots {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-outside-roots",
      .severity = Severity::kWarning,
      .summary = "a template reads a file outside of its packages",
      .why = "The file is in none of the packages that the template names, nor in its own "
             "repository. It is missing on another machine, and a template from elsewhere can "
             "bring any file of this machine into the robot in this way.",
      .what_to_do = "Move the file into a package, and name it with $(find PACKAGE).",
      .checks = {on_xacro({FactKind::kOutsideRoots}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_outside_roots
