// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::physics_type_unknown {

// The engines of both Gazebos, and what worlds write where the engine is chosen elsewhere.
constexpr std::array<std::string_view, 9> kTypes = {
    "ode", "bullet", "simbody", "dart", "tpe", "bullet-featherstone", "ignored", "ignore", "none"};

void check(const model::Physics& physics, Context& context) {
  const auto& type = physics.type;
  if (!type.written || type.value.empty()) return;
  if (std::find(kTypes.begin(), kTypes.end(), type.value) != kTypes.end()) return;
  const auto near = schema::near(type.value, {kTypes.begin(), kTypes.end()});
  context.report({.where = type.span,
                  .message = "'" + type.value + "' is no physics engine that is known",
                  .help = near.empty() ? "the engines are ode, bullet, simbody and dart"
                                       : "did you mean '" + std::string(near.front()) + "'?",
                  .fix = nearest_instead(type.value, {kTypes.begin(), kTypes.end()}, type.span)});
}

Rule rule() {
  return {
      .name = "physics-type-unknown",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a world names a physics engine that does not exist",
      .why = "Gazebo classic refuses to load the world; new Gazebo does not look at the name and "
             "uses its own engine.",
      .what_to_do = "Write ode, bullet, simbody or dart; new Gazebo chooses the engine by its "
                    "physics plugin or on its command line.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::physics_type_unknown
