// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::duplicate_sibling_name {

void check(const model::Root& /*root*/, Context& context) {
  for (const NameScope& scope : context.repeated_names()) {
    for_each_repetition(
        scope, Kinds::kDifferent, [&context](const Named& first, const Named& again) {
          context.report({.where = again.where,
                          .message = "the " + std::string(again.kind) + " '" +
                                     std::string(again.name) + "' has the name of a " +
                                     std::string(first.kind),
                          .subject = subject_of(again),
                          .related = {{first.where, "the " + std::string(first.kind)}}});
        });
  }
}

Rule rule() {
  return {
      .name = "duplicate-sibling-name",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "things of different kinds in one scope have the same name",
      .why = "A pose may refer to any link, joint, frame or model of a scope by name, so they "
             "share one set of names: from SDF 1.7 on libsdformat refuses the file; of an older "
             "one it renames the later kind while it reads, so that nobody finds it by the name "
             "that is written. Its check (ign sdf -k) refuses both, and a visual with the name of "
             "its collision too, which simulators load all the same.",
      .what_to_do = "Rename one of them, as to elbow_joint.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::duplicate_sibling_name
