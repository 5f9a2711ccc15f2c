// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertial_missing {
namespace {

/// What the shapes would have in place of the 1 kg·m²; empty when they have no closed form.
std::string comparison(const model::Link& link, Context& context) {
  auto solid = solid_of_all(link, mass::From::kCollisions, context);
  if (!solid) solid = solid_of_all(link, mass::From::kVisuals, context);
  if (!solid || !(solid->mass > 0)) return {};
  const mass::Inertia& tensor = solid->about_com;
  const double most = std::max({tensor.ixx, tensor.iyy, tensor.izz}) / solid->mass;
  return fmt::format("as a solid of 1 kg its shapes have at most {:.3g} kg·m², {:.3g} times {}",
                     most, most < 1 ? 1 / most : most, most < 1 ? "less" : "more");
}

void check(const model::Link& link, Context& context) {
  if (link.inertial.written || !is_dynamic(link, context)) return;
  context.report({.where = link.site.name,
                  .message = "the link '" + link.name.value +
                             "' has no <inertial>: it is taken to be 1 kg with a moment of 1 kg·m² "
                             "about every axis",
                  .subject = context.subject(link),
                  .help = comparison(link, context),
                  .fix = fix_from_shapes(link, context)});
}

}  // namespace

Rule rule() {
  return {
      .name = "inertial-missing",
      .category = Category::kInertia,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a link that moves has no <inertial>",
      .why =
          "SDF takes 1 kg and the identity as its tensor, as of a ball more than three metres "
          "across. "
          "Joints on it move like in honey, and what rests on it is thrown about.",
      .what_to_do =
          "`rigor inertia MODEL --mass LINK=KG --write` computes the tensor from the link's shapes "
          "and "
          "meshes, and writes it; without a mass it takes that of water. If the link never moves, "
          "make the model static.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <«link» name="body">
      <collision name="hull">
        <geometry><box><size>0.3 0.2 0.1</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)",
               // 6 litres of water: m / 12 (y² + z²) = 0.5 (0.04 + 0.01), and so on.
               R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <inertial>
        <mass>6</mass>
        <inertia>
          <ixx>0.025</ixx>
          <ixy>0</ixy>
          <ixz>0</ixz>
          <iyy>0.05</iyy>
          <iyz>0</iyz>
          <izz>0.065</izz>
        </inertia>
      </inertial>
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
