// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The fix that all rules about inertials share: what the link's shapes have as solids, written in
// place of what is there. `rigor inertia` writes the same numbers.

#pragma once

#include <optional>

#include <fmt/core.h>

#include <rigor/mass/proposal.h>
#include <rigor/rules/context.h>
#include <rigor/write/write_inertial.h>

namespace rigor::rules {

/// Nothing when neither the collisions nor the visuals are all solids.
inline std::optional<Fix> fix_from_shapes(const model::Link& link, Context& context) {
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto proposal = mass::propose(link.inertial, context.body(link, from), {});
    if (!proposal) continue;
    const auto format = context.is_urdf() ? write::BlockFormat::kUrdf : write::BlockFormat::kSdf;
    auto edits = write::write_inertial(context.document(), context.element(link.site),
                                       proposal->body, format);
    if (edits.empty()) return std::nullopt;
    return Fix{fmt::format("write the inertial of its shapes as solids, {:.4g} kg at {:.4g} kg/m³",
                           proposal->body.mass, proposal->body.mass / proposal->volume),
               Applicability::kUnsafe, std::move(edits)};
  }
  return std::nullopt;
}

}  // namespace rigor::rules
