// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_package_not_found {

using rigor::xacro::FactKind;

void check(const rigor::xacro::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = describe(fact),
                  .help = "Name its folder with --package " + fact.name + "=DIR",
                  .cause = fact.name});
}

/// The robot is known, and the path is all that is not.
void check_path(const rigor::xacro::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = describe(fact),
                  .help = "Name its folder with --package " + fact.name + "=DIR",
                  .cause = fact.name,
                  .why = "xacro ends with \"PackageNotFoundError\" unless the package is installed "
                         "where it runs. Nothing else of the robot depends on the folder, so it is "
                         "checked.",
                  .severity = Severity::kWarning});
}

Rule rule() {
  return {
      .name = "xacro-package-not-found",
      .severity = Severity::kError,
      .summary = "$(find …) names a package that is not found",
      .why =
          "xacro ends with \"PackageNotFoundError\", so nothing is loaded, unless the package"
          " is installed where it runs. What its files define is unknown, so only links that "
          "lack nothing are checked, and rules on whole robots are not run. Where no file of the "
          "package is read, as in a path that is given to a plugin, it is a warning, and the "
          "robot is checked.",
      .what_to_do = "Correct the name, name the folder with `--package NAME=DIR` or in `[resolve] "
                    "packages` of rigor.toml, or source the workspace.",
      .checks = {on_xacro({FactKind::kPackageNotFound}, check),
                 on_xacro({FactKind::kPackageUnresolved}, check_path)},
  };
}

}  // namespace rigor::rules::xacro_package_not_found
