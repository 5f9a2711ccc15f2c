// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::duplicate_name {

/// URDF tells links, joints and materials by name, and nothing below them.
bool counts(const NameScope& scope, const Named& named, const Context& context) {
  if (!context.is_urdf()) return true;
  return scope.of == "robot" &&
         (named.kind == "link" || named.kind == "joint" || named.kind == "material");
}

void check(const model::Root& /*root*/, Context& context) {
  for (const NameScope& scope : context.repeated_names()) {
    for_each_repetition(scope, Kinds::kSame, [&](const Named& first, const Named& again) {
      if (!counts(scope, again, context)) return;
      context.report({.where = again.where,
                      .message = "a second " + std::string(again.kind) + " is called '" +
                                 std::string(again.name) + "'",
                      .subject = subject_of(again),
                      .related = {{first.where, "the first"}}});
    });
  }
}

Rule rule() {
  return {
      .name = "duplicate-name",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "two things of one kind have the same name",
      .why = "libsdformat and urdfdom refuse the file. Where they do not, one of the two cannot be "
             "referred to.",
      .what_to_do = "Rename one of them. Of two includes of one model, one takes a <name>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::duplicate_name
