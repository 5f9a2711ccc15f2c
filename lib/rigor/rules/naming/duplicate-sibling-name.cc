// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::duplicate_sibling_name {
namespace {

constexpr int kFirstStrictVersion = 7;  // older files are renamed while they are read

void check(const model::Root& /*root*/, Context& context) {
  for (const NameScope& scope : name_scopes(context)) {
    const bool shared = scope.of == NameScope::Of::kModel || scope.of == NameScope::Of::kWorld;
    if (!shared || scope.version < kFirstStrictVersion) continue;
    for_each_repetition(scope, Kinds::kDifferent, [&context](const Named& first, const Named& again) {
      context.report({.where = again.where,
                      .message = "the " + std::string(again.kind) + " '" + std::string(again.name) +
                                 "' has the name of a " + std::string(first.kind),
                      .subject = again.subject,
                      .related = {{first.where, "the " + std::string(first.kind)}}});
    });
  }
}

}  // namespace

Rule rule() {
  return {
      .name = "duplicate-sibling-name",
      .category = Category::kNaming,
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "things of different kinds in one scope have the same name",
      .why =
          "From SDF 1.7 on, links, joints, frames and nested models of a model, and models, "
          "joints and frames of a world, share one set of names, since a pose may refer to any of "
          "them: libsdformat refuses the file.",
      .what_to_do = "Rename one of them, as to elbow_joint.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <frame name="«body»"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <frame name="lid"/>
  </model>
</sdf>
)"}},
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::duplicate_sibling_name
