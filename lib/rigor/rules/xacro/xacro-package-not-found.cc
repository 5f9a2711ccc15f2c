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

Rule rule() {
  return {
      .name = "xacro-package-not-found",
      .severity = Severity::kError,
      .summary = "$(find …) names a package that is not found",
      .why = "xacro ends with \"PackageNotFoundError\", so nothing is loaded, unless the package"
             " is installed where it runs. What its files define is unknown, so the rest is "
             "checked without"
             " them, and rules on whole robots are not run.",
      .what_to_do = "Correct the name, name the folder with `--package NAME=DIR` or in `[resolve] "
                    "packages` of rigor.toml, or source the workspace.",
      .checks = {on_xacro({FactKind::kPackageNotFound}, check)},
  };
}

}  // namespace rigor::rules::xacro_package_not_found
