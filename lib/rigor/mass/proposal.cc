// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/proposal.h>

#include <cmath>

namespace rigor::mass {
namespace {

/// Solids have tensors that a body can have, unless their numbers run out of a double's range.
bool in_range(const MassProperties& body) {
  const Inertia& i = body.about_com;
  for (const double positive : {body.mass, i.ixx, i.iyy, i.izz}) {
    if (!(positive > 0) || !std::isfinite(positive)) return false;
  }
  return true;
}

}  // namespace

std::optional<Proposal> propose(const model::Inertial& written, const LinkBody& shapes,
                                const MassWish& wish) {
  if (!shapes.complete()) return std::nullopt;
  Proposal proposal;
  proposal.volume = of_density(shapes, 1).mass;
  proposal.body = wish.density ? of_density(shapes, *wish.density) : of_own_densities(shapes);
  const model::Field<double>& mass = written.mass;
  if (wish.mass) {
    proposal.mass_from = MassFrom::kGiven;
    proposal.body = with_mass(proposal.body, *wish.mass);
  } else if (!wish.density && mass.written && mass.value > 0 && std::isfinite(mass.value)) {
    proposal.mass_from = MassFrom::kWritten;
    proposal.body = with_mass(proposal.body, mass.value);
  }
  if (!in_range(proposal.body)) return std::nullopt;
  return proposal;
}

}  // namespace rigor::mass
