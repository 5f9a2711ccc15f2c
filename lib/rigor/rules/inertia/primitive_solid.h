// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a link would have were its shapes solid and its mass spread evenly over them.

#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <rigor/mass/shapes.h>
#include <rigor/model/model.h>

namespace rigor::rules {

/// Of all collisions, or all visuals; nothing unless every one is a shape with a closed form.
template <class Part>
std::optional<mass::MassProperties> solid_of_all(const model::Root& root,
                                                 const std::vector<model::Id<Part>>& parts) {
  mass::MassProperties sum;  // of density 1
  for (const model::Id<Part> id : parts) {
    const Part& part = root[id];
    const auto solid = mass::solid_of(part.geometry.shape);
    if (!solid || !part.pose.relative_to.value.empty()) return std::nullopt;
    sum = mass::add(
        sum, mass::transformed(part.pose.pose.value, mass::with_mass(*solid, solid->volume)));
  }
  if (parts.empty()) return std::nullopt;
  return sum;
}

/// How many times larger the moments (their sum) are than those of the solid of the same mass; of
/// collisions and visuals, whichever agree better. Nothing when neither can be computed.
inline std::optional<double> share_of_solid(const model::Root& root, const model::Link& link,
                                            double mass, const mass::Inertia& tensor) {
  std::optional<double> best;
  for (const auto& solid :
       {solid_of_all(root, link.collisions), solid_of_all(root, link.visuals)}) {
    if (!solid || !(solid->mass > 0) || !(mass > 0)) continue;
    const double share = mass::trace(tensor) / (mass / solid->mass * mass::trace(solid->about_com));
    if (!best || std::abs(std::log(share)) < std::abs(std::log(*best))) best = share;
  }
  return best;
}

// A hollow shape has up to three times the moments of a solid one, and a shape may show only a part
// of the body; what is off by less than this can be meant.
inline constexpr double kPlausible = 10;

inline bool plausible(double share) { return share < kPlausible && share > 1 / kPlausible; }

}  // namespace rigor::rules
