// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/proposal.h>

#include <array>
#include <charconv>
#include <cmath>

namespace rigor::mass {
namespace {

/// Whether the shapes can be the body. Solids have tensors that a body can have, unless their numbers
/// run out of a double's range.
bool can_be(const Proposal& proposal) {
  const MassProperties& body = proposal.body;
  const Inertia& i = body.about_com;
  for (const double positive : {body.mass, i.ixx, i.iyy, i.izz}) {
    if (!(positive > 0) || !std::isfinite(positive)) return false;
  }
  return body.mass <= kDensest * proposal.volume &&
         trace(i) <= 2 * kFarthest * kFarthest * body.mass;
}

/// To nine significant digits, as masses are written.
double as_written(double mass) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), mass, std::chars_format::scientific, 8);
  std::from_chars(text.data(), end.ptr, mass);
  return mass;
}

}  // namespace

std::optional<Proposal> propose(const model::Inertial& written, const LinkBody& shapes,
                                const MassRequest& wish) {
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
  } else {
    proposal.body = with_mass(proposal.body, as_written(proposal.body.mass));
  }
  if (!can_be(proposal)) return std::nullopt;
  return proposal;
}

}  // namespace rigor::mass
