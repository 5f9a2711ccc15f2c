// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a link would have were its shapes solid and its mass spread evenly over them.

#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <rigor/mass/link_body.h>
#include <rigor/mass/proposal.h>
#include <rigor/mass/shapes.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

// A hollow shape has up to three times the moments of a solid one, and a shape may show only a part
// of the body; what is off by less than this can be meant.
inline constexpr double kPlausible = 10;

// A body that is lighter was given its mass, or its size, in another unit.
inline constexpr double kAir = 1.5;  // kg/m³

inline bool plausible(double share) { return share < kPlausible && share > 1 / kPlausible; }

/// Whether a URDF's shape has a size that cannot be read: the model then holds SDF's default, which
/// nobody takes.
inline bool has_unread_size(const model::Shape& shape) {
  if (const auto* box = std::get_if<model::Box>(&shape)) return !box->size.written;
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) return !ball->radius.written;
  const auto* cylinder = std::get_if<model::Cylinder>(&shape);
  return cylinder != nullptr && !(cylinder->radius.written && cylinder->length.written);
}

inline bool has_unread_size(const model::Link& link, const Context& context) {
  if (!context.is_urdf()) return false;
  const auto any = [&context](const auto& parts) {
    return std::any_of(parts.begin(), parts.end(), [&context](auto id) {
      return has_unread_size(context.root()[id].geometry.shape);
    });
  };
  return any(link.collisions) || any(link.visuals);
}

/// Of all collisions, or all visuals, at density 1; nothing unless each of them is a solid.
inline std::optional<mass::MassProperties> solid_of_all(const model::Link& link, mass::From from,
                                                        Context& context) {
  if (has_unread_size(link, context)) return std::nullopt;
  const mass::LinkBody& body = context.body(link, from);
  if (!body.complete()) return std::nullopt;
  return mass::of_density(body, 1);
}

/// How many times larger the moments (their sum) are than those of the solid of the same mass; of
/// collisions and visuals, whichever agree better. Nothing when neither can be computed.
inline std::optional<double> share_of_solid(const model::Link& link, double mass,
                                            const mass::Inertia& tensor, Context& context) {
  std::optional<double> best;
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || !(solid->mass > 0) || !(mass > 0)) continue;
    if (mass > mass::kDensest * solid->mass) continue;  // a placeholder, not the body
    const double share = mass::trace(tensor) / (mass / solid->mass * mass::trace(solid->about_com));
    if (!best || std::abs(std::log(share)) < std::abs(std::log(*best))) best = share;
    if (plausible(*best)) break;  // the visuals' meshes need not be opened
  }
  return best;
}

}  // namespace rigor::rules
