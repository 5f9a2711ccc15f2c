// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_not_written {
namespace {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!(inertial.mass.value > 0)) return;  // mass-negative and mass-zero speak of that
  if (!inertial.mass.written || inertial.tensor_written || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context)) return;
  context.report(
      {.where = inertial.site.name,
       .message = fmt::format("the mass is {} kg, but there is no <inertia>: the moments "
                              "are taken to be 1 kg·m²",
                              inertial.mass.value),
       .subject = context.subject(link)});
}

}  // namespace

Rule rule() {
  return {
      .name = "inertia-not-written",
      .category = Category::kInertia,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a mass is written without an inertia tensor",
      .why =
          "SDF then takes the identity as the tensor, whatever the mass: a wheel of 100 g "
          "turns as hard as a door.",
      .what_to_do =
          "Write the tensor that the mass has in its shape, as of a solid box: "
          "ixx = mass / 12 * (y² + z²).",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <«inertial»>
        <mass>0.1</mass>
      </inertial>
    </link>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <link name="body">
      <inertial>
        <mass>0.1</mass>
        <inertia>
          <ixx>0.001</ixx>
          <iyy>0.001</iyy>
          <izz>0.001</izz>
        </inertia>
      </inertial>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_not_written
