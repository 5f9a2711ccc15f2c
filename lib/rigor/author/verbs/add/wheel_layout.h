// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which wheels of a model drive it and how far they are apart, for plugins that must be given these numbers.
//
//   const WheelLayout layout = wheel_layout(*edited);
//   if (layout.problem.empty()) use(layout.left, layout.separation);
//
// Forward is x of the model, left is y. Wheels are found by their shapes (robot/assembled/axles.h); those behind a joint
// that swivels freely are casters.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/author/verbs/edited_model.h>

namespace rigor::author {

/// Of joints about an upright axis that carry a pair of wheels.
struct SteeringLayout {
  std::string left, right;  ///< joints
  double kingpin = 0;       ///< m, between them
  double wheel_base = 0;    ///< m, from their axle to that of the other wheels
  double limit = 0;         ///< rad, to either side
};

struct WheelLayout {
  std::vector<std::string> left, right;  ///< joints of wheels, a pair at each index
  double separation = 0;                 ///< m, between the middles of a pair
  double radius = 0;                     ///< m
  std::optional<SteeringLayout> steering;
  std::string problem;  ///< why there is no layout, as the end of a sentence
};

/// Without `steering`, wheels that are steered are left out: a differential drive has none.
WheelLayout wheel_layout(const EditedModel& edited);

}  // namespace rigor::author
