// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/fact.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/package/tried.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_not_found {

void check(const read::Fact& fact, Context& context) {
  const std::string other = context.resolve(fact.name).other_case;
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is not found",
                  .help = other.empty()
                              ? tried_places(fact.tried, fact.name)
                              : "there is '" + other + "': letters are told apart by case"});
}

Rule rule() {
  return {
      .name = "include-not-found",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included model is not found",
      .why = "libsdformat refuses the whole file; Gazebo leaves the model out.",
      .what_to_do =
          "Correct the URI, or say where the model is: --model-path, the paths in rigor.toml, "
          "GZ_SIM_RESOURCE_PATH, or for package:// --package and ROS_PACKAGE_PATH.",
      .checks = {on_read({read::FactKind::kIncludeNotFound}, check)},
  };
}

}  // namespace rigor::rules::include_not_found
