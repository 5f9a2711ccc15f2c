// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertial_missing {
namespace {

void check(const model::Link& link, Context& context) {
  if (link.inertial.written || !is_dynamic(link, context)) return;
  context.report({.where = link.site.name,
                  .message = "the link '" + link.name.value +
                             "' has no <inertial>: it is taken to be 1 kg with a moment of 1 kg·m² "
                             "about every axis",
                  .subject = context.subject(link)});
}

}  // namespace

Rule rule() {
  return {
      .name = "inertial-missing",
      .category = Category::kInertia,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a link that moves has no <inertial>",
      .why =
          "SDF gives such a link a mass of 1 kg and the identity as its tensor, which is what "
          "a ball of 1 kg and more than three metres across has: joints on it move like in "
          "honey, and what rests on it is thrown about.",
      .what_to_do =
          "Write the mass and the tensor; rigor inertia MODEL --only missing computes "
          "them from the shapes. If the link never moves, make the model static.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <«link» name="body">
      <collision name="hull">
        <geometry><box><size>0.3 0.2 0.1</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <collision name="hull">
        <geometry><box><size>0.3 0.2 0.1</size></box></geometry>
      </collision>
      <inertial>
        <mass>1</mass>
        <inertia>
          <ixx>0.004</ixx>
          <iyy>0.008</iyy>
          <izz>0.011</izz>
        </inertia>
      </inertial>
    </link>
  </model>
</sdf>
)"},
               {R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertial_missing
