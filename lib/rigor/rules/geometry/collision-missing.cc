// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::collision_missing {
namespace {

void check(const model::Link& link, Context& context) {
  if (link.visuals.empty() || !link.collisions.empty()) return;
  if (link.kinematic.value || is_static(context.root(), link.model)) return;
  context.report({.where = link.site.name,
                  .message = "the link '" + link.name.value +
                             "' can be seen but not touched: it has a visual and no collision",
                  .subject = context.subject(link)});
}

}  // namespace

Rule rule() {
  return {
      .name = "collision-missing",
      .category = Category::kGeometry,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a link that moves has a visual but no collision",
      .why =
          "It falls through the ground and other bodies pass through it. That is often meant, "
          "for a small part that is fixed to another.",
      .what_to_do = "Add a collision, best a simple shape about the visual.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <«link» name="body">
      <visual name="hull">
        <geometry>
          <box><size>1 2 3</size></box>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body">
      <visual name="hull">
        <geometry>
          <box><size>1 2 3</size></box>
        </geometry>
      </visual>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::collision_missing
