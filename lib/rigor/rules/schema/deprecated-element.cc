// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::deprecated_element {
namespace {

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view instead = fact.node->instead();
  const auto since = fact.node->deprecated_since();
  std::string message = "'" + std::string(fact.node->name()) + "' is deprecated";
  if (context.is_sdf() && since) message += " since SDF " + schema::to_string(*since);
  context.report({.where = fact.where,
                  .message = std::move(message),
                  .subject = subject_of(fact.element),
                  .help = instead.empty() ? "" : "write " + std::string(instead)});
}

}  // namespace

Rule rule() {
  return {
      .name = "deprecated-element",
      .category = Category::kSchema,
      .severity = Severity::kInfo,
      .summary = "an element or attribute is deprecated in this version",
      .why = "It still has its effect, and will lose it in a later version of the format.",
      .what_to_do = "Write what the message names in its place.",
      .bad = {{R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="continuous">
    <parent link="base"/>
    <child link="tip"/>
    <axis xyz="0 0 1"/>
    <«joint_properties» damping="0.1"/>
  </joint>
</robot>
)"}},
      .good = {{R"(<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="continuous">
    <parent link="base"/>
    <child link="tip"/>
    <axis xyz="0 0 1"/>
    <dynamics damping="0.1"/>
  </joint>
</robot>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kDeprecated}, check)},
  };
}

}  // namespace rigor::rules::deprecated_element
