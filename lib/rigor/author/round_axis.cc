// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/round_axis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace rigor::author {
namespace {

/// Sides of a part that is round differ by its facets: those of a hexagonal prism by 15 %, of a dodecagonal one by 4.
constexpr double kEqualSides = 0.05;

/// How much farther than half the sides a vertex of a round part may be: those of a facetted one are at the
/// corners, by 8 % of an octagonal prism; those of a square one by 41 %.
constexpr double kCornerRadius = 1.15;

/// The third side of a part that has an axis worth naming.
constexpr double kOtherSide = 0.15;

bool differ_by(double a, double b, double share) {
  return std::abs(a - b) > share * std::max(std::abs(a), std::abs(b));
}

using Coordinates = std::array<double, 3>;

Coordinates coordinates(const model::Vector3& v) { return {v.x, v.y, v.z}; }

struct Extent {
  Coordinates min;
  Coordinates max;

  double side(unsigned i) const { return max[i] - min[i]; }
  double from_middle(unsigned i, const Coordinates& at) const {
    return at[i] - (min[i] + max[i]) / 2;
  }
};

Extent extent_of(std::span<const model::Vector3> vertices) {
  Extent extent{coordinates(vertices.front()), coordinates(vertices.front())};
  for (const model::Vector3& vertex : vertices) {
    const Coordinates at = coordinates(vertex);
    for (unsigned i = 0; i < 3; ++i) {
      extent.min[i] = std::min(extent.min[i], at[i]);
      extent.max[i] = std::max(extent.max[i], at[i]);
    }
  }
  return extent;
}

bool is_round_about(unsigned i, std::span<const model::Vector3> vertices, const Extent& extent) {
  const unsigned j = (i + 1) % 3;
  const unsigned k = (i + 2) % 3;
  if (differ_by(extent.side(j), extent.side(k), kEqualSides)) return false;
  const double max = kCornerRadius * std::max(extent.side(j), extent.side(k)) / 2;
  return std::all_of(vertices.begin(), vertices.end(), [&](const model::Vector3& vertex) {
    const Coordinates at = coordinates(vertex);
    return std::hypot(extent.from_middle(j, at), extent.from_middle(k, at)) <= max;
  });
}

}  // namespace

std::optional<Axis> round_axis(std::span<const model::Vector3> vertices) {
  if (vertices.empty()) return std::nullopt;
  const Extent extent = extent_of(vertices);
  const model::Vector3 size{extent.side(0), extent.side(1), extent.side(2)};
  if (const auto by_size = round_axis(size)) return by_size;
  std::optional<Axis> found;
  for (unsigned i = 0; i < 3; ++i) {
    if (!is_round_about(i, vertices, extent)) continue;
    if (found) return std::nullopt;
    found = static_cast<Axis>(i);
  }
  return found;
}

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
