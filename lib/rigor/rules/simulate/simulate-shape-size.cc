// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_shape_size {
namespace {

std::string words_for(const simulate::Fact& fact) {
  if (fact.name == "scale") return "the scale of a mesh has a zero in it";
  if (fact.name == "point") return "the polyline encloses nothing";
  return fmt::format("the {} of a collision is {:.6g} m, and must be above 0",
                     fact.name == "radii" ? "least radius" : fact.name, fact.value);
}

}  // namespace

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, words_for(fact)));
}

Rule rule() {
  return {
      .name = "simulate-shape-size",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "a collision's size is not positive",
      .why =
          "ODE ends the process on negative sizes, and takes a size of zero silently: nothing"
          " collides with it then.",
      .what_to_do = "Write the size in metres, above zero.",
      .checks = {on_simulation({simulate::FactKind::kShapeSize}, check)},
  };
}

}  // namespace rigor::rules::simulate_shape_size
