// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::unknown_attribute {
namespace {

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view name = fact.attribute->name();
  if (meant_for_missing(fact, name)) return;
  const auto near = schema::near(name, node_names(fact.parent->attributes()));
  std::optional<Fix> fix;
  if (near.size() == 1 && !fact.element.attribute(near.front())) {
    const std::string meant(near.front());
    fix = Fix{"write '" + meant + "'", Applicability::kUnsafe, {{fact.where, meant}}};
  }
  context.report({.where = fact.where,
                  .message = "'" + std::string(name) + "' is no attribute of <" +
                             std::string(fact.element.name()) + ">: it has no effect",
                  .subject = subject_of(fact.element),
                  .help = near.empty() ? "" : "did you mean '" + std::string(near.front()) + "'?",
                  .fix = std::move(fix)});
}

}  // namespace

Rule rule() {
  return {
      .name = "unknown-attribute",
      .category = Category::kSchema,
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "an attribute that the format does not have",
      .why = "libsdformat warns, urdfdom and Gazebo say nothing; what it says has no effect.",
      .what_to_do =
          "Write the name that was meant. Attributes of your own take a prefix, as "
          "mine:note=\"…\", and are left alone.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <frame name="lid" «atached_to»="body"/>
    <link name="body"/>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <frame name="lid" attached_to="body"/>
    <link name="body"/>
  </model>
</sdf>
)"},
              {R"(<robot name="box">
  <link name="body" «colour»="red"/>
</robot>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <frame name="lid" attached_to="body"/>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kUnknownAttribute}, check)},
  };
}

}  // namespace rigor::rules::unknown_attribute
