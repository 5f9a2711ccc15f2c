// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/hollow.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace rigor::mass {
namespace {

using model::Vector3;

/// A quantity of the outer and of the inner solid, and how much they differ. The gap of a product is
/// AB - ab = (A - a)B + a(B - b): sums of what is not negative, so nothing cancels. (R³ - r³ comes
/// out as t(R² + Rr + r²) by itself.)
struct Pair {
  double outer = 0;
  double inner = 0;
  double gap = 0;
};

Pair operator+(const Pair& a, const Pair& b) {
  return {a.outer + b.outer, a.inner + b.inner, a.gap + b.gap};
}

Pair operator*(const Pair& a, const Pair& b) {
  return {a.outer * b.outer, a.inner * b.inner, a.gap * b.outer + a.inner * b.gap};
}

Pair operator*(double factor, const Pair& p) {
  return {factor * p.outer, factor * p.inner, factor * p.gap};
}

/// A length that the wall shortens by `by`; nothing is left inside when it is not that long.
Pair inset(double size, double by) { return {size, std::max(0.0, size - by), std::min(size, by)}; }

Pair kept(double size) { return {size, size, 0}; }

/// ∫ dV, ∫ x² dV, ∫ y² dV and ∫ z² dV about the origin, which is the center of mass.
struct WallMoments {
  Pair volume, xx, yy, zz;
};

Solid difference(const WallMoments& m) {
  const double xx = m.xx.gap / m.volume.gap;
  const double yy = m.yy.gap / m.volume.gap;
  const double zz = m.zz.gap / m.volume.gap;
  return {m.volume.gap, {}, {.ixx = yy + zz, .iyy = xx + zz, .izz = xx + yy}};
}

struct HollowFormer {
  double wall;

  using Answer = std::optional<Solid>;

  Answer operator()(const model::Box& s) const { return hollow_box(s.size.value, wall); }
  Answer operator()(const model::Sphere& s) const { return hollow_sphere(s.radius.value, wall); }
  Answer operator()(const model::Cylinder& s) const {
    return hollow_cylinder(s.radius.value, s.length.value, wall);
  }
  Answer operator()(const model::Capsule& s) const {
    return hollow_capsule(s.radius.value, s.length.value, wall);
  }
  Answer operator()(const model::Cone& s) const {
    return hollow_cone(s.radius.value, s.length.value, wall);
  }
  Answer operator()(const model::Ellipsoid& s) const {
    return hollow_ellipsoid(s.radii.value, wall);
  }
  template <class Other>
  Answer operator()(const Other&) const {
    return std::nullopt;
  }
};

}  // namespace

Solid hollow_box(const Vector3& size, double wall) {
  const Pair x = inset(size.x, 2 * wall);
  const Pair y = inset(size.y, 2 * wall);
  const Pair z = inset(size.z, 2 * wall);
  const Pair volume = x * y * z;
  return difference({volume, 1.0 / 12 * (volume * x * x), 1.0 / 12 * (volume * y * y),
                     1.0 / 12 * (volume * z * z)});
}

Solid hollow_sphere(double radius, double wall) {
  return hollow_ellipsoid({radius, radius, radius}, wall);
}

Solid hollow_cylinder(double radius, double length, double wall) {
  const Pair r = inset(radius, wall);
  const Pair l = inset(length, 2 * wall);
  const Pair volume = std::numbers::pi * (r * r * l);
  const Pair across = 0.25 * (volume * r * r);
  return difference({volume, across, across, 1.0 / 12 * (volume * l * l)});
}

Solid hollow_capsule(double radius, double length, double wall) {
  const Pair r = inset(radius, wall);
  const Pair l = kept(length);
  const Pair tube = std::numbers::pi * (r * r * l);
  const Pair ball = 4.0 / 3 * std::numbers::pi * (r * r * r);
  const Pair across = 0.25 * (tube * r * r) + 0.2 * (ball * r * r);
  const Pair along =
      1.0 / 12 * (tube * l * l) + ball * (0.2 * (r * r) + 0.25 * (l * l) + 0.375 * (r * l));
  return difference({tube + ball, across, across, along});
}

// A wall of the same thickness everywhere leaves a cone of the same angles, whose faces are nearer to
// the center of the inscribed ball by the wall: the inner cone is the outer one shrunk about that center
// by 1 - wall/inradius. The inradius is that of the circle inscribed in the triangle of sides 2r, s, s
// (area over half the perimeter): r h/(r + s), s² = r² + h². WallMoments of degree n about the center shrink
// with the power n + 3 of the ratio.
Solid hollow_cone(double radius, double length, double wall) {
  const double inradius = radius * length / (radius + std::hypot(radius, length));
  const Pair ratio = inset(1, wall / inradius);
  const Pair cubed = ratio * ratio * ratio;
  const double center = length / 4 - inradius;  // of the outer cone's mass, above the ball's center
  const Solid outer = cone(radius, length);
  const double first = center * (cubed * ratio).gap / cubed.gap;
  const double fifth = (cubed * ratio * ratio).gap / cubed.gap;
  const double across = 0.15 * radius * radius * fifth;
  const double along = (0.0375 * length * length + center * center) * fifth - first * first;
  return {outer.volume * cubed.gap,
          {0, 0, inradius - length / 2 + first},
          {.ixx = across + along, .iyy = across + along, .izz = 2 * across}};
}

Solid hollow_ellipsoid(const Vector3& radii, double wall) {
  const Pair x = inset(radii.x, wall);
  const Pair y = inset(radii.y, wall);
  const Pair z = inset(radii.z, wall);
  const Pair volume = 4.0 / 3 * std::numbers::pi * (x * y * z);
  return difference(
      {volume, 0.2 * (volume * x * x), 0.2 * (volume * y * y), 0.2 * (volume * z * z)});
}

std::optional<Solid> hollow(const model::Shape& shape, double wall) {
  if (!(wall > 0) || !std::isfinite(wall) || !solid_of(shape)) return std::nullopt;
  return std::visit(HollowFormer{wall}, shape);
}

}  // namespace rigor::mass
