// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::include_uri_missing {

void check(const model::Include& include, Context& context) {
  if (!include.uri.value.empty()) return;
  context.report({.where = include.site.name, .message = "this <include> names no model"});
}

Rule rule() {
  return {
      .name = "include-uri-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "an include names no model",
      .why = "libsdformat refuses the whole file, and Gazebo with it.",
      .what_to_do = "Write the <uri> of the model, as in <uri>model://box</uri>.",
      .checks = {on<model::Include>(check)},
  };
}

}  // namespace rigor::rules::include_uri_missing
