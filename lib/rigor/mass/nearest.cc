// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rigor::mass {

std::optional<Inertia> nearest_possible(const Inertia& inertia) {
  const PrincipalAxes principal = principal_axes(inertia);
  const auto& moments = principal.moments;
  const double half_trace = (moments[0] + moments[1] + moments[2]) / 2;
  if (!std::isfinite(half_trace)) return std::nullopt;
  std::array<double, 3> spread{};  // second moments along the principal axes, kg·m²
  double sum = 0;
  for (std::size_t i = 0; i < spread.size(); ++i) {
    spread[i] = std::max(half_trace - moments[i], 0.0);
    sum += spread[i];
  }
  if (!(sum > 0)) return std::nullopt;
  Inertia nearest;
  for (std::size_t i = 0; i < spread.size(); ++i) {
    const double second_moment = std::max(spread[i], kMinSpread * sum);
    // As of a point mass on the axis: |p|² 1 - p pᵀ.
    nearest = nearest + point_inertia(second_moment, principal.axes[i]);
  }
  return nearest;
}

}  // namespace rigor::mass
