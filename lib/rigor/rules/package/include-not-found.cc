// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/fact.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/package/missing_part.h>
#include <rigor/rules/package/tried.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_not_found {

std::string help(const read::Fact& fact, const read::Resolution& found, Context& context) {
  if (!found.other_case.empty())
    return "there is '" + found.other_case + "': names are case-sensitive";
  const std::string model = "model://" + fact.name;
  if (found.scheme.empty() && context.resolve(model).path) return "write " + model;
  return tried_places(fact.tried, fact.name, context.path());
}

void check(const read::Fact& fact, Context& context) {
  const read::Resolution& found = context.resolve(fact.name);
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is not found",
                  .help = help(fact, found, context),
                  .cause = missing_part(fact.name, found, context)});
}

Rule rule() {
  return {
      .name = "include-not-found",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included model is not found",
      .why = "libsdformat rejects the whole file, and gz sim does not start; Gazebo classic asks "
             "its public database of models, and leaves out what that does not have.",
      .what_to_do =
          "Correct the URI, or give the model's folder: --model-path, the paths in rigor.toml, "
          "GZ_SIM_RESOURCE_PATH, or for package:// --package and ROS_PACKAGE_PATH.",
      .checks = {on_read({read::FactKind::kIncludeNotFound}, check)},
  };
}

}  // namespace rigor::rules::include_not_found
