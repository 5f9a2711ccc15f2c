// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/round_axis.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace rigor::author {
namespace {

/// Sides of a part that is round differ by its facets: those of a hexagonal prism by 15 %, of a dodecagonal one by 4.
constexpr double kEqualSides = 0.05;

/// The third side of a part that has an axis worth naming.
constexpr double kOtherSide = 0.15;

bool differ_by(double a, double b, double share) {
  return std::abs(a - b) > share * std::max(std::abs(a), std::abs(b));
}

}  // namespace

std::optional<Axis> round_axis(const model::Vector3& size) {
  const double sides[] = {size.x, size.y, size.z};
  for (unsigned i = 0; i < 3; ++i) {
    const double other = sides[(i + 1) % 3];
    const double third = sides[(i + 2) % 3];
    if (differ_by(other, third, kEqualSides) || !differ_by(sides[i], other, kOtherSide)) continue;
    return static_cast<Axis>(i);
  }
  return std::nullopt;
}

std::optional<Axis> round_axis(const model::Shape& shape) {
  if (std::holds_alternative<model::Cylinder>(shape) ||
      std::holds_alternative<model::Capsule>(shape) || std::holds_alternative<model::Cone>(shape)) {
    return Axis::kZ;
  }
  if (const auto* box = std::get_if<model::Box>(&shape)) return round_axis(box->size.value);
  if (const auto* ellipsoid = std::get_if<model::Ellipsoid>(&shape)) {
    return round_axis(ellipsoid->radii.value);
  }
  return std::nullopt;
}

model::Vector3 turn_between(Axis from, Axis to) {
  constexpr double kQuarter = std::numbers::pi / 2;
  if (from == to) return {};
  const auto a = static_cast<unsigned>(from);
  const auto b = static_cast<unsigned>(to);
  // About the third axis; x to y, y to z and z to x turn forward.
  const double angle = b == (a + 1) % 3 ? kQuarter : -kQuarter;
  switch (3 - a - b) {
    case 0: return {angle, 0, 0};
    case 1: return {0, angle, 0};
    default: return {0, 0, angle};
  }
}

}  // namespace rigor::author
