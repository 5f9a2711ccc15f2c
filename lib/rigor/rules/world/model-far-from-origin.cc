// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::model_far_from_origin {

// At 10 km a number of single precision, which renderers and some engines count in, has steps of 1 mm.
constexpr double kFar = 10'000;  // m

template <class Placed>
void check(const Placed& placed, Context& context) {
  const model::PoseField& pose = placed.pose;
  if (!placed.world || !pose.pose.written || !pose.relative_to.value.empty()) return;
  const model::Vector3& p = pose.pose.value.translation;
  const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!(far > kFar) || !std::isfinite(far)) return;
  context.report({.where = pose.pose.span,
                  .message = fmt::format("the model '{}' is {:.4g} km from the middle of the world",
                                         placed.name.value, length(p) / 1000)});
}

Rule rule() {
  return {
      .name = "model-far-from-origin",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a model of a world is more than 10 km from its middle",
      .why = "Renderers and some engines count in single precision, which beyond 10 km has steps "
             "of a millimetre and more: what is there trembles. Nobody sees it from where the "
             "others are, either. Mostly it fell through the ground, or was flung away, before the "
             "world was saved.",
      .what_to_do = "Put the model back where it belongs. A world on the globe has its place in "
                    "<spherical_coordinates>, and its models near 0 0 0.",
      .checks = {on<model::Model>(check), on<model::Include>(check)},
  };
}

}  // namespace rigor::rules::model_far_from_origin
