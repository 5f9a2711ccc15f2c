// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::gravity_upward {
namespace {

void check(const model::World& world, Context& context) {
  const model::Vector3& gravity = world.gravity.value;
  if (!world.gravity.written || gravity.z <= 0) return;
  context.report({.where = world.gravity.span,
                  .message = fmt::format("gravity points up: z is {} m/s²", gravity.z),
                  .subject = context.subject(world),
                  .help = "the z axis of a world points up, so gravity is 0 0 -9.8"});
}

}  // namespace

Rule rule() {
  return {
      .name = "gravity-upward",
      .category = Category::kWorld,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "the world's gravity points up",
      .why =
          "The world's z axis points up, against gravity. With the sign forgotten everything that "
          "is not static leaves the ground at the first step, in every simulator.",
      .what_to_do = "Write the vector with a minus sign: 0 0 -9.8.",
      .bad = {{R"(<sdf version="1.9">
  <world name="lab">
    <gravity>«0 0 9.8»</gravity>
  </world>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <world name="lab">
    <gravity>0 0 -9.8</gravity>
  </world>
</sdf>
)"},
               {R"(<sdf version="1.9">
  <world name="orbit">
    <gravity>0 0 0</gravity>
  </world>
</sdf>
)"}},
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::gravity_upward
