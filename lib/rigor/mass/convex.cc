// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/convex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace rigor::mass {
namespace {

using model::Vector3;

// Curved shapes that nearly touch take the most; what is undecided then is called apart.
constexpr int kMaxSteps = 100;

// Halvings of the depth: to 1/128 of the inradius.
constexpr int kHalvings = 7;

Vector3 scaled(const Vector3& v, const Vector3& by) { return {v.x * by.x, v.y * by.y, v.z * by.z}; }

/// Points of the difference of two shapes.
struct Simplex {
  std::array<Vector3, 4> points;
  std::size_t count = 0;

  void keep(std::initializer_list<Vector3> kept) {
    count = 0;
    for (const Vector3& p : kept) points[count++] = p;
  }
};

double square(const Vector3& v) { return dot(v, v); }

/// The point of a segment, triangle or tetrahedron that is nearest to the origin; of its corners those
/// stay that span the part where it lies. (C. Ericson, "Real-Time Collision Detection", 2005, §5.1.)
Vector3 nearest_of_line(Simplex& s) {
  const auto [a, b, c, d] = s.points;
  const Vector3 ab = b - a;
  const double along = -dot(a, ab), whole = square(ab);
  if (along <= 0 || whole == 0) return s.keep({a}), a;
  if (along >= whole) return s.keep({b}), b;
  return a + (along / whole) * ab;
}

Vector3 nearest_of_triangle(Simplex& s) {
  const auto [a, b, c, d] = s.points;
  const Vector3 ab = b - a, ac = c - a;
  const double a1 = -dot(ab, a), a2 = -dot(ac, a);
  if (a1 <= 0 && a2 <= 0) return s.keep({a}), a;
  const double b1 = -dot(ab, b), b2 = -dot(ac, b);
  if (b1 >= 0 && b2 <= b1) return s.keep({b}), b;
  const double of_c = a1 * b2 - b1 * a2;
  if (of_c <= 0 && a1 >= 0 && b1 <= 0) return s.keep({a, b}), nearest_of_line(s);
  const double c1 = -dot(ab, c), c2 = -dot(ac, c);
  if (c2 >= 0 && c1 <= c2) return s.keep({c}), c;
  const double of_b = c1 * a2 - a1 * c2;
  if (of_b <= 0 && a2 >= 0 && c2 <= 0) return s.keep({a, c}), nearest_of_line(s);
  const double of_a = b1 * c2 - c1 * b2;
  if (of_a <= 0 && b2 - b1 >= 0 && c1 - c2 >= 0) return s.keep({b, c}), nearest_of_line(s);
  const double share = 1 / (of_a + of_b + of_c);
  return a + (of_b * share) * ab + (of_c * share) * ac;
}

Vector3 nearest_of_tetrahedron(Simplex& s) {
  const auto [a, b, c, d] = s.points;
  Simplex best;
  std::optional<Vector3> nearest;
  // Each face, and the corner that is not on it.
  for (const auto& [p, q, r, other] : {std::array{a, b, c, d}, std::array{a, c, d, b},
                                       std::array{a, d, b, c}, std::array{b, d, c, a}}) {
    const Vector3 normal = cross(q - p, r - p);
    if (dot(normal, p) * dot(normal, p - other) > 0) continue;  // the origin is on the inner side
    Simplex face;
    face.keep({p, q, r});
    const Vector3 point = nearest_of_triangle(face);
    if (nearest && square(point) >= square(*nearest)) continue;
    nearest = point;
    best = face;
  }
  if (!nearest) return {};
  s = best;
  return *nearest;
}

Vector3 nearest_of(Simplex& simplex) {
  switch (simplex.count) {
    case 2: return nearest_of_line(simplex);
    case 3: return nearest_of_triangle(simplex);
    case 4: return nearest_of_tetrahedron(simplex);
    default: return simplex.points[0];
  }
}

bool is_positive(const Vector3& v) {
  return v.x > 0 && v.y > 0 && v.z > 0 && std::isfinite(v.x + v.y + v.z);
}

/// Along (x, y), from the axis out to the radius.
Vector3 on_rim(const Vector3& d, double radius) {
  const double flat = std::hypot(d.x, d.y);
  if (flat == 0) return {};
  return {radius * d.x / flat, radius * d.y / flat, 0};
}

/// The diameter, when the radius lies between the two.
double ball_between(const ConvexShape& a, const ConvexShape& b, double inside, double outside) {
  for (int i = 0; i < kHalvings; ++i) {
    const double depth = (inside + outside) / 2;
    (share_a_point(a.shrunk(depth), b.shrunk(depth)) ? inside : outside) = depth;
  }
  return 2 * inside;
}

}  // namespace

std::optional<ConvexShape> ConvexShape::of(const model::Shape& shape, const model::Pose& X_WS) {
  ConvexShape result;
  result.X_WS_ = X_WS;
  Vector3& half = result.half_;
  const auto round = [](const auto& s) {
    return Vector3{s.radius.value, s.radius.value, s.length.value / 2};
  };
  if (const auto* box = std::get_if<model::Box>(&shape)) {
    result.kind_ = Kind::kBox;
    half = 0.5 * box->size.value;
  } else if (const auto* ball = std::get_if<model::Sphere>(&shape)) {
    result.kind_ = Kind::kBall;
    half = {ball->radius.value, ball->radius.value, ball->radius.value};
  } else if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) {
    result.kind_ = Kind::kCylinder;
    half = round(*cylinder);
  } else if (const auto* capsule = std::get_if<model::Capsule>(&shape)) {
    result.kind_ = Kind::kCapsule;
    half = round(*capsule);
  } else if (const auto* cone = std::get_if<model::Cone>(&shape)) {
    result.kind_ = Kind::kCone;
    half = round(*cone);
  } else if (const auto* ellipsoid = std::get_if<model::Ellipsoid>(&shape)) {
    result.kind_ = Kind::kEllipsoid;
    half = ellipsoid->radii.value;
  } else {
    return std::nullopt;
  }
  if (!is_positive(half)) return std::nullopt;
  result.inradius_ = std::min({half.x, half.y, half.z});
  if (result.kind_ == Kind::kCapsule) result.inradius_ = half.x;
  if (result.kind_ == Kind::kCone) {
    // Of the triangle that its section is: area over half the perimeter.
    const double height = 2 * half.z;
    result.inradius_ = half.x * height / (half.x + std::hypot(half.x, height));
  }
  return result;
}

Vector3 ConvexShape::farthest_in_shape(const Vector3& d) const {
  const double end = d.z < 0 ? -half_.z : half_.z;
  switch (kind_) {
    case Kind::kBox: return {d.x < 0 ? -half_.x : half_.x, d.y < 0 ? -half_.y : half_.y, end};
    case Kind::kBall: {
      const double size = length(d);
      return size == 0 ? Vector3{} : (half_.x / size) * d;
    }
    case Kind::kCylinder: return on_rim(d, half_.x) + Vector3{0, 0, end};
    case Kind::kCapsule: {
      const double size = length(d);
      return (size == 0 ? Vector3{} : (half_.x / size) * d) + Vector3{0, 0, end};
    }
    case Kind::kCone: {
      const Vector3 base = on_rim(d, half_.x) + Vector3{0, 0, -half_.z};
      const Vector3 apex{0, 0, half_.z};
      return dot(apex, d) > dot(base, d) ? apex : base;
    }
    case Kind::kEllipsoid: {
      // R² d / |R d|
      const Vector3 rd = scaled(half_, d);
      const double size = length(rd);
      return size == 0 ? Vector3{} : (1 / size) * scaled(half_, rd);
    }
  }
  return {};
}

Vector3 ConvexShape::farthest(const Vector3& direction_W) const {
  return transform(X_WS_, farthest_in_shape(rotate(conjugate(X_WS_.rotation), direction_W)));
}

mesh::Bounds ConvexShape::bounds() const {
  const model::Quaternion R_SW = conjugate(X_WS_.rotation);
  const auto reach = [this](const Vector3& d_S) { return dot(d_S, farthest_in_shape(d_S)); };
  const Vector3 x_S = rotate(R_SW, {1, 0, 0});
  const Vector3 y_S = rotate(R_SW, {0, 1, 0});
  const Vector3 z_S = rotate(R_SW, {0, 0, 1});
  return {X_WS_.translation - Vector3{reach(-1 * x_S), reach(-1 * y_S), reach(-1 * z_S)},
          X_WS_.translation + Vector3{reach(x_S), reach(y_S), reach(z_S)}};
}

ConvexShape ConvexShape::shrunk(double depth) const {
  ConvexShape result = *this;
  result.inradius_ -= depth;
  switch (kind_) {
    case Kind::kBox:
    case Kind::kBall:
    case Kind::kCylinder: result.half_ = half_ - Vector3{depth, depth, depth}; break;
    case Kind::kCapsule: result.half_ = {half_.x - depth, half_.y - depth, half_.z}; break;
    case Kind::kEllipsoid: result.half_ = (1 - depth / inradius_) * half_; break;
    case Kind::kCone: {
      // Smaller about the center of the ball inside, which touches the base.
      const double share = 1 - depth / inradius_;
      const Vector3 middle{0, 0, inradius_ - half_.z};
      result.half_ = share * half_;
      result.X_WS_.translation = transform(X_WS_, (1 - share) * middle);
      break;
    }
  }
  return result;
}

bool share_a_point(const ConvexShape& a, const ConvexShape& b) {
  Simplex simplex;
  Vector3 nearest = a.center() - b.center();
  double left = square(nearest);
  for (int step = 0; step < kMaxSteps && left > 0; ++step) {
    const Vector3 p = a.farthest(-1 * nearest) - b.farthest(nearest);
    if (dot(p, nearest) > 0) return false;
    simplex.points[simplex.count++] = p;
    nearest = nearest_of(simplex);
    if (simplex.count == 4) return true;
    // What comes no nearer is at the end of what numbers can tell: it touches.
    if (step > 0 && !(square(nearest) < left)) return true;
    left = square(nearest);
  }
  return left == 0;
}

double common_ball(const ConvexShape& a, const ConvexShape& b) {
  if (!share_a_point(a, b)) return 0;
  return ball_between(a, b, 0, std::min(a.inradius(), b.inradius()));
}

double refined_common_ball(const ConvexShape& a, const ConvexShape& b, double rough) {
  const double error = std::min(a.inradius(), b.inradius()) / (1 << kHalvings);
  return ball_between(a, b, rough / 2, rough / 2 + error);
}

}  // namespace rigor::mass
