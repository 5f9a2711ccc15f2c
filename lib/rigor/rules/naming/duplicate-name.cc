// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::duplicate_name {
namespace {

void check(const model::Root& root, Context& context) {
  const bool urdf = context.is_urdf();
  for (const NameScope& scope : name_scopes(context)) {
    if (urdf && scope.of == NameScope::Of::kLink) continue;  // URDF does not tell shapes by name
    for_each_repetition(scope, Kinds::kSame, [&context](const Named& first, const Named& again) {
      context.report({.where = again.where,
                      .message = "a second " + std::string(again.kind) + " is called '" +
                                 std::string(again.name) + "'",
                      .subject = again.subject,
                      .related = {{first.where, "the first"}}});
    });
  }
  NameScope materials{NameScope::Of::kFile, 0, {}};
  for (const model::RobotMaterial& material : root.materials) {
    if (!root.own(material.site)) continue;
    materials.members.push_back({"material", material.name.value, material.name.span, {}});
  }
  for_each_repetition(materials, Kinds::kSame, [&context](const Named& first, const Named& again) {
    context.report({.where = again.where,
                    .message = "a second material is called '" + std::string(again.name) + "'",
                    .related = {{first.where, "the first"}}});
  });
}

}  // namespace

Rule rule() {
  return {
      .name = "duplicate-name",
      .category = Category::kNaming,
      .severity = Severity::kError,
      .summary = "two things of one kind have the same name",
      .why =
          "libsdformat and urdfdom refuse the file. Where they do not, one of the two cannot be "
          "referred to.",
      .what_to_do = "Rename one of them. Of two includes of one model, one takes a <name>.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <link name="«body»"/>
  </model>
</sdf>
)"},
              {R"(<sdf version="1.9">
  <world name="lab">
    <include>
      <uri>box</uri>
    </include>
    <«include»>
      <uri>box</uri>
    </include>
  </world>
</sdf>
=== box/model.config
<model><name>box</name><sdf version="1.9">model.sdf</sdf></model>
=== box/model.sdf
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
    <link name="lid"/>
  </model>
</sdf>
)"},
               {R"(<sdf version="1.9">
  <world name="lab">
    <include>
      <uri>box</uri>
    </include>
    <include>
      <uri>box</uri>
      <name>second_box</name>
    </include>
  </world>
</sdf>
=== box/model.config
<model><name>box</name><sdf version="1.9">model.sdf</sdf></model>
=== box/model.sdf
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::duplicate_name
