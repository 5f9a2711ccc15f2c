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
struct MassRequest {
  std::optional<double> mass = {};     ///< kg
  std::optional<double> density = {};  ///< kg/m³, of every part
};

struct Proposal {
  MassProperties body;  ///< in the link frame
  MassFrom mass_from = MassFrom::kDensity;
  double volume = 0;  ///< m³, the sum of the parts'
};

/// Denser than osmium (22,590 kg/m³) is nothing: shapes with so much mass are not the whole body.
inline constexpr double kDensest = 25'000;  // kg/m³

/// No part of a robot reaches this far: a mesh that does is in millimeters.
inline constexpr double kFarthest = 100;  // m, radius of gyration

/// Without a wish, the written mass when it is above zero; else the parts' own densities, which are
/// water's unless the file says otherwise. A mass from a density is rounded to the digits that are
/// written, so that what is computed from the written one is the same. Nothing when a part is no solid,
/// or when the shapes are too small or too large to be the body: kDensest, kFarthest.
std::optional<Proposal> propose(const model::Inertial& written, const LinkBody& shapes,
                                const MassRequest& wish);

}  // namespace rigor::mass
