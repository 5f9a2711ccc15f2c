// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The inertial that a link's shapes propose: which mass, spread evenly over them.
//
//   if (auto proposal = propose(link.inertial, link_body(…), {})) write(proposal->body);

#pragma once

#include <cstdint>
#include <optional>

#include <rigor/mass/link_body.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/model/model.h>

namespace rigor::mass {

/// Where a proposed mass comes from.
enum class MassFrom : std::uint8_t { kGiven, kDensity, kWritten };

/// What somebody asks for; the first that is there decides.
struct MassWish {
  std::optional<double> mass = {};     ///< kg
  std::optional<double> density = {};  ///< kg/m³, of every part
};

struct Proposal {
  MassProperties body;  ///< in the link frame
  MassFrom mass_from = MassFrom::kDensity;
  double volume = 0;  ///< m³, the sum of the parts'
};

/// Without a wish, the written mass when it is above zero; else the parts' own densities, which are
/// water's unless the file says otherwise. Nothing when a part is no solid, or when the numbers are too
/// small or too large to compute with.
std::optional<Proposal> propose(const model::Inertial& written, const LinkBody& shapes,
                                const MassWish& wish);

}  // namespace rigor::mass
