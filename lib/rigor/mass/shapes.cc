// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/shapes.h>

#include <cmath>
#include <numbers>

#include <rigor/mass/polyline.h>

namespace rigor::mass {
namespace {

using model::Vector3;

Inertia diagonal(double xx, double yy, double zz) { return {xx, 0, 0, yy, 0, zz}; }

bool usable(double size) { return size > 0 && std::isfinite(size); }
bool usable(const Vector3& v) { return usable(v.x) && usable(v.y) && usable(v.z); }

struct SolidFormer {
  std::optional<Solid> operator()(const model::Box& s) const {
    if (!usable(s.size.value)) return std::nullopt;
    return box(s.size.value);
  }
  std::optional<Solid> operator()(const model::Sphere& s) const {
    if (!usable(s.radius.value)) return std::nullopt;
    return sphere(s.radius.value);
  }
  std::optional<Solid> operator()(const model::Cylinder& s) const { return round(s, cylinder); }
  std::optional<Solid> operator()(const model::Capsule& s) const { return round(s, capsule); }
  std::optional<Solid> operator()(const model::Cone& s) const { return round(s, cone); }
  std::optional<Solid> operator()(const model::Ellipsoid& s) const {
    if (!usable(s.radii.value)) return std::nullopt;
    return ellipsoid(s.radii.value);
  }
  std::optional<Solid> operator()(const model::Polyline& s) const { return solid_of(s); }
  template <class Other>
  std::optional<Solid> operator()(const Other&) const {
    return std::nullopt;
  }

  template <class Shape>
  static std::optional<Solid> round(const Shape& shape, Solid (*form)(double, double)) {
    if (!usable(shape.radius.value) || !usable(shape.length.value)) return std::nullopt;
    return form(shape.radius.value, shape.length.value);
  }
};

}  // namespace

Solid box(const Vector3& size) {
  const double xx = size.x * size.x;
  const double yy = size.y * size.y;
  const double zz = size.z * size.z;
  return {size.x * size.y * size.z, {}, diagonal((yy + zz) / 12, (xx + zz) / 12, (xx + yy) / 12)};
}

Solid sphere(double radius) { return ellipsoid({radius, radius, radius}); }

Solid cylinder(double radius, double length) {
  const double rr = radius * radius;
  const double across = (3 * rr + length * length) / 12;
  return {std::numbers::pi * rr * length, {}, diagonal(across, across, rr / 2)};
}

Solid capsule(double radius, double length) {
  const double rr = radius * radius;
  const double tube = std::numbers::pi * rr * length;
  const double ball = 4.0 / 3 * std::numbers::pi * rr * radius;
  const double volume = tube + ball;
  const double across = tube / volume * (3 * rr + length * length) / 12 +
                        ball / volume * (0.4 * rr + length * length / 4 + 0.375 * radius * length);
  const double along = tube / volume * rr / 2 + ball / volume * 0.4 * rr;
  return {volume, {}, diagonal(across, across, along)};
}

Solid cone(double radius, double length) {
  const double rr = radius * radius;
  const double across = 3.0 / 80 * (4 * rr + length * length);
  return {
      std::numbers::pi * rr * length / 3, {0, 0, -length / 4}, diagonal(across, across, 0.3 * rr)};
}

Solid ellipsoid(const Vector3& radii) {
  const double xx = radii.x * radii.x;
  const double yy = radii.y * radii.y;
  const double zz = radii.z * radii.z;
  return {4.0 / 3 * std::numbers::pi * radii.x * radii.y * radii.z,
          {},
          diagonal((yy + zz) / 5, (xx + zz) / 5, (xx + yy) / 5)};
}

std::optional<Solid> solid_of(const model::Shape& shape) {
  return std::visit(SolidFormer{}, shape);
}

MassProperties with_mass(const Solid& solid, double mass) {
  return {mass, solid.com, mass * solid.unit_inertia};
}

MassProperties of_density(const Solid& solid, double density) {
  return with_mass(solid, density * solid.volume);
}

}  // namespace rigor::mass
