// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/refused_inertia.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mass_negative {
namespace {

void check(const model::Link& link, Context& context) {
  const auto& mass = link.inertial.mass;
  if (!mass.written || !(mass.value < 0) || !std::isfinite(mass.value)) return;
  context.report({.where = mass.span,
                  .message = fmt::format("the mass is {} kg: it must be above zero", mass.value),
                  .subject = context.subject(link),
                  .fix = fix_from_shapes(link, context),
                  .refused = refuses_inertia(link, context)});
}

}  // namespace

Rule rule() {
  return {
      .name = "mass-negative",
      .category = Category::kInertia,
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a mass is negative",
      .why =
          "libsdformat refuses the model. urdfdom takes it, and the simulation then explodes: "
          "what is pushed comes nearer.",
      .what_to_do = "Write a mass above zero.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <inertial>
        <mass>«-1»</mass>
        <inertia>
          <ixx>0.01</ixx>
          <iyy>0.01</iyy>
          <izz>0.01</izz>
        </inertia>
      </inertial>
      <collision name="hull">
        <geometry><box><size>0.3 0.2 0.1</size></box></geometry>
      </collision>
    </link>
  </model>
</sdf>
)",
               // Six litres of water; a solid box has m / 12 (y² + z²) and so on.
               R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <inertial>
        <mass>6</mass>
        <inertia>
          <ixx>0.025</ixx>
          <iyy>0.05</iyy>
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
      <inertial>
        <mass>1</mass>
        <inertia>
          <ixx>0.01</ixx>
          <iyy>0.01</iyy>
          <izz>0.01</izz>
        </inertia>
      </inertial>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_negative
