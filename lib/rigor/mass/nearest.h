// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The rigid body nearest to an inertia tensor that no rigid body can have.
//
//   if (!judge(mass, I).possible()) I = nearest_possible(I);
//
// A tensor I is possible when the second moments of the mass, Σ = ½ tr(I) 1 - I, are positive
// semidefinite. Its projection, in the Frobenius norm, keeps the axes and sets what is negative to zero
// (N. J. Higham, "Computing a nearest symmetric positive semidefinite matrix", 1988; Σ: P. M. Wensing,
// S. Kim, J.-J. E. Slotine, RA-L 2018).

#pragma once

#include <optional>

#include <rigor/mass/mass_properties.h>

namespace rigor::mass {

/// Of the sum of a body's second moments, what each has at least: that of a plate 2 % as thick as it is wide.
/// It survives six digits and the tolerances of consumers, which reject a flat plate.
inline constexpr double kMinSpread = 1e-4;

/// kg·m², about the same point and along the same axes as `inertia`; nothing for a tensor that is not
/// finite, or that has no positive second moment to begin with.
std::optional<Inertia> nearest_possible(const Inertia& inertia);

}  // namespace rigor::mass
