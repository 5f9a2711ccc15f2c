// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::duplicate_name {

/// URDF tells links, joints and materials by name, and nothing below them. An SRDF has a state of one name for each
/// group.
bool counts(const NameScope& scope, const Named& named, const Context& context) {
  const bool is_srdf = context.root().format == model::Format::kUnknown;
  if (!context.is_urdf() && !is_srdf) return true;
  return scope.of == "robot" &&
         (named.kind == "link" || named.kind == "joint" || named.kind == "material");
}

bool is_include(const Named& named, const Context& context) {
  for (auto at = context.document().element_at(named.where.begin); at; at = at->parent()) {
    if (at->name() == "include") return true;
  }
  return false;
}

void check(const model::Root& /*root*/, Context& context) {
  for (const NameScope& scope : context.repeated_names()) {
    for_each_repetition(scope, Kinds::kSame, [&](const Named& first, const Named& again) {
      if (!counts(scope, again, context)) return;
      context.report({.where = again.where,
                      .message = "a second " + std::string(again.kind) + " is called '" +
                                 std::string(again.name) + "'",
                      .subject = subject_of(again),
                      .related = {{first.where, "the first"}},
                      .help = again.kind == "model" && is_include(again, context)
                                  ? "give the <include> a <name> of its own"
                                  : "",
                      .cause = std::string(again.name)});
    });
  }
}

Rule rule() {
  return {
      .name = "duplicate-name",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "duplicate name",
      .why = "libsdformat rejects the file. urdfdom rejects the robot. Where a reader accepts it, "
             "one of the two cannot be referred to.",
      .what_to_do = "Rename one of them. Give one of two includes of the same model a <name>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::duplicate_name
