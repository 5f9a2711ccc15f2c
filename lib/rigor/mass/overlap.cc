// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/overlap.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include <rigor/mass/shapes.h>

namespace rigor::mass {
namespace {

using model::Vector3;

// Points tried in the smaller shape's box.
constexpr int kPoints = 8000;

// A share below this is what touching shapes with rounded sizes have.
constexpr double kMin = 1e-3;

/// Half the sides of the box around a shape, in its own frame.
struct HalfExtent {
  Vector3 operator()(const model::Box& s) const { return 0.5 * s.size.value; }
  Vector3 operator()(const model::Sphere& s) const {
    return {s.radius.value, s.radius.value, s.radius.value};
  }
  Vector3 operator()(const model::Cylinder& s) const { return round(s, 0); }
  Vector3 operator()(const model::Cone& s) const { return round(s, 0); }
  Vector3 operator()(const model::Capsule& s) const { return round(s, s.radius.value); }
  Vector3 operator()(const model::Ellipsoid& s) const { return s.radii.value; }
  template <class Other>
  Vector3 operator()(const Other&) const {
    return {};
  }
  template <class Shape>
  static Vector3 round(const Shape& s, double cap) {
    return {s.radius.value, s.radius.value, s.length.value / 2 + cap};
  }
};

struct Contains {
  const Vector3& p;

  bool operator()(const model::Box& s) const {
    return within(p.x, s.size.value.x) && within(p.y, s.size.value.y) &&
           within(p.z, s.size.value.z);
  }
  bool operator()(const model::Sphere& s) const { return dot(p, p) <= square(s.radius.value); }
  bool operator()(const model::Cylinder& s) const {
    return within(p.z, s.length.value) && flat_square() <= square(s.radius.value);
  }
  bool operator()(const model::Cone& s) const {
    const double radius = s.radius.value * (0.5 - p.z / s.length.value);
    return within(p.z, s.length.value) && flat_square() <= square(radius);
  }
  bool operator()(const model::Capsule& s) const {
    const double beyond = std::max(0.0, std::abs(p.z) - s.length.value / 2);
    return flat_square() + square(beyond) <= square(s.radius.value);
  }
  bool operator()(const model::Ellipsoid& s) const {
    const Vector3& r = s.radii.value;
    return square(p.x / r.x) + square(p.y / r.y) + square(p.z / r.z) <= 1;
  }
  template <class Other>
  bool operator()(const Other&) const {
    return false;
  }

  double flat_square() const { return p.x * p.x + p.y * p.y; }
  static double square(double value) { return value * value; }
  static bool within(double value, double side) { return std::abs(value) <= side / 2; }
};

/// The i-th point of a sequence that fills the unit cube evenly: shares of the plastic number's
/// three-dimensional cousin (M. Roberts, "The unreasonable effectiveness of quasirandom sequences",
/// 2018).
Vector3 spread_point(int i) {
  const auto share = [i](double step) {
    const double value = 0.5 + i * step;
    return value - std::floor(value);
  };
  return {share(0.8191725133961645), share(0.6710436067037893), share(0.5497004779019703)};
}

}  // namespace

double reach_of(const model::Shape& shape) { return length(std::visit(HalfExtent{}, shape)); }

double overlap(const PlacedShape& a, const PlacedShape& b) {
  const auto solid_a = solid_of(a.shape);
  const auto solid_b = solid_of(b.shape);
  if (!solid_a || !solid_b) return 0;
  const bool a_is_smaller = solid_a->volume < solid_b->volume;
  const PlacedShape& small = a_is_smaller ? a : b;
  const PlacedShape& large = a_is_smaller ? b : a;
  const Vector3 half = std::visit(HalfExtent{}, small.shape);
  const model::Pose X_large_small = compose(inverse(large.X_LS), small.X_LS);
  if (length(X_large_small.translation) > length(half) + reach_of(large.shape)) return 0;
  int inside = 0;
  int shared = 0;
  for (int i = 1; i <= kPoints; ++i) {
    const Vector3 unit = spread_point(i);
    const Vector3 p{(2 * unit.x - 1) * half.x, (2 * unit.y - 1) * half.y,
                    (2 * unit.z - 1) * half.z};
    if (!std::visit(Contains{p}, small.shape)) continue;
    ++inside;
    const Vector3 q = transform(X_large_small, p);
    if (std::visit(Contains{q}, large.shape)) ++shared;
  }
  const double share = inside > 0 ? static_cast<double>(shared) / inside : 0;
  return share < kMin ? 0 : share;
}

}  // namespace rigor::mass
