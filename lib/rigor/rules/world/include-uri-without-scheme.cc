// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>

#include <rigor/rules/plugin/simulator.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_uri_without_scheme {

/// Whether others of the file have it, so that it was not left out by principle, and it is for Gazebo classic.
bool is_needed(const model::Root& root) {
  const bool is_new = std::any_of(root.plugins.begin(), root.plugins.end(), [](const auto& plugin) {
    return is_of_new_gazebo(plugin.filename.value);
  });
  if (is_new) return false;
  return std::any_of(root.includes.begin(), root.includes.end(), [&](const model::Include& other) {
    return root.own(other.site) && other.uri.value.starts_with("model://");
  });
}

void check(const model::Include& include, Context& context) {
  const std::string& uri = include.uri.value;
  // A path to a file is meant as one.
  if (uri.empty() || uri.find_first_of(":/\\.$") != uri.npos) return;
  if (!context.resolve(uri).path) return;  // include-not-found
  std::optional<Fix> fix;
  if (context.bytes(include.uri.span) == uri) {
    fix = Fix{"write model://", Applicability::kUnsafe, {{include.uri.span, "model://" + uri}}};
  }
  context.report({.where = include.uri.span,
                  .message = "the <include> names '" + uri + "' without model://",
                  .fix = std::move(fix),
                  .severity = is_needed(context.root()) ? Severity::kWarning : Severity::kInfo});
}

Rule rule() {
  return {
      .name = "include-uri-without-scheme",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "an include names a model without model://",
      .why = "A name alone is a path: libsdformat and Gazebo classic look for it in the working "
             "directory and in their own data, so that the world loads in one folder and not in "
             "another. Gazebo Sim searches GZ_SIM_RESOURCE_PATH, too: in a world with its "
             "systems, or where no include has model://, the finding is an info.",
      .what_to_do = "Write model:// and the name of the model's folder.",
      .checks = {on<model::Include>(check)},
  };
}

}  // namespace rigor::rules::include_uri_without_scheme
