// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::include_uri_missing {

void check(const model::Include& include, Context& context) {
  if (!include.uri.value.empty()) return;
  const bool old = context.element(include.site).attribute("filename").has_value();
  context.report({.where = include.site.name,
                  .message = old ? "<include> has no <uri>: 'filename' is read in SDF 1.0 only"
                                 : "<include> has no <uri>",
                  .help = old ? "write <uri>model://NAME</uri> in place of the attribute" : ""});
}

Rule rule() {
  return {
      .name = "include-uri-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "include without a URI",
      .why = "libsdformat rejects the whole file, and Gazebo with it.",
      .what_to_do = "Write the <uri> of the model, as in <uri>model://box</uri>.",
      .checks = {on<model::Include>(check)},
  };
}

}  // namespace rigor::rules::include_uri_missing
