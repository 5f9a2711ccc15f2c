// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sibling_name_shared {
namespace {

constexpr int kFirstStrictVersion = 7;

void check(const model::Root& /*root*/, Context& context) {
  for (const NameScope& scope : name_scopes(context)) {
    // In a link most visuals share the name of their collision, and nobody minds.
    if (scope.of == NameScope::Of::kLink || scope.version >= kFirstStrictVersion) continue;
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
      .name = "sibling-name-shared",
      .category = Category::kNaming,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "things of different kinds have the same name, as this version allows",
      .why =
          "libsdformat's own check, ign sdf -k, objects to a visual and a collision of one name, "
          "and renames a link, joint or frame of a file before SDF 1.7; simulators load the file.",
      .what_to_do = "Rename one of them before the file is upgraded.",
      .bad = {{R"(<sdf version="1.6">
  <model name="arm">
    <link name="elbow"/>
    <joint name="«elbow»" type="fixed">
      <parent>world</parent>
      <child>elbow</child>
    </joint>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.6">
  <model name="arm">
    <link name="elbow"/>
    <joint name="elbow_joint" type="fixed">
      <parent>world</parent>
      <child>elbow</child>
    </joint>
  </model>
</sdf>
)"}},
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::sibling_name_shared
