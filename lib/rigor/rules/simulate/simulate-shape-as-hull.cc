// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_shape_as_hull {

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, fmt::format("the {} is simulated as the convex hull of points on it",
                                         fact.name.empty() ? "shape" : fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-shape-as-hull",
      .category = Category::kSimulate,
      .severity = Severity::kInfo,
      .summary = "a shape is simulated as a convex hull of points on it",
      .why =
          "ODE has no ellipsoids, cones and polylines; their hull of many points differs from "
          "them by less than a hundredth of their size. A polyline with a notch loses it.",
      .what_to_do =
          "Nothing, unless the exact curvature matters: then a sphere, box, cylinder or "
          "capsule is exact.",
      .checks = {on_simulation({simulate::FactKind::kShapeAsHull}, check)},
  };
}

}  // namespace rigor::rules::simulate_shape_as_hull
