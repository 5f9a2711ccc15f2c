// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/oriented_box.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace rigor::robot {
namespace {

using model::Vector3;

/// How far it reaches from its center along a unit vector, m.
double half_shadow(const OrientedBox& box, const Vector3& d) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += box.half[k] * std::abs(dot(box.axes_W[k], d));
  return sum;
}

// Thinner ones, such as a plane's, share no volume with anything.
constexpr double kThinnest = 1e-3;  // m

std::pair<double, double> interval(double low, double high) {
  const double more = std::max(0.0, kThinnest - (high - low)) / 2;
  return {low - more, high + more};
}

struct Volumes {
  double a = 1, b = 1, both = 1;  // m³
};

Volumes volumes(const mesh::Bounds& a, const mesh::Bounds& b) {
  Volumes result;
  for (const double Vector3::*axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
    const auto [a_low, a_high] = interval(a.min.*axis, a.max.*axis);
    const auto [b_low, b_high] = interval(b.min.*axis, b.max.*axis);
    result.a *= a_high - a_low;
    result.b *= b_high - b_low;
    result.both *= std::max(0.0, std::min(a_high, b_high) - std::max(a_low, b_low));
  }
  return result;
}

}  // namespace

OrientedBox box_around(const mesh::Bounds& bounds_S, const model::Pose& X_WS) {
  const Vector3 half = 0.5 * (bounds_S.max - bounds_S.min);
  return {transform(X_WS, 0.5 * (bounds_S.min + bounds_S.max)),
          {rotate(X_WS.rotation, {1, 0, 0}), rotate(X_WS.rotation, {0, 1, 0}),
           rotate(X_WS.rotation, {0, 0, 1})},
          {std::abs(half.x), std::abs(half.y), std::abs(half.z)}};
}

OrientedBox moved(OrientedBox box, const Vector3& d_W) {
  box.center_W = box.center_W + d_W;
  return box;
}

double separation(const OrientedBox& a, const OrientedBox& b) {
  const Vector3 between = b.center_W - a.center_W;
  double most = -std::numeric_limits<double>::infinity();
  // The axes of b, and the way to it, along those of a.
  std::array<std::array<double, 3>, 3> R{}, absolute{};
  std::array<double, 3> t{};
  bool parallel = true;  // so that each normal of two edges is one of a face
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = dot(between, a.axes_W[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      R[i][j] = dot(a.axes_W[i], b.axes_W[j]);
      absolute[i][j] = std::abs(R[i][j]);
      constexpr double kRounding = 1e-12;
      parallel = parallel && (absolute[i][j] < kRounding || absolute[i][j] > 1 - kRounding);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const double of_b =
        b.half[0] * absolute[i][0] + b.half[1] * absolute[i][1] + b.half[2] * absolute[i][2];
    most = std::max(most, std::abs(t[i]) - a.half[i] - of_b);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const double apart = std::abs(t[0] * R[0][j] + t[1] * R[1][j] + t[2] * R[2][j]);
    const double of_a =
        a.half[0] * absolute[0][j] + a.half[1] * absolute[1][j] + a.half[2] * absolute[2][j];
    most = std::max(most, apart - of_a - b.half[j]);
  }
  // Nearly parallel edges have no common normal, and the faces have looked there already.
  constexpr double kParallel = 1e-5;
  for (std::size_t i = 0; i < 3 && !parallel; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const double sine2 = 1 - R[i][j] * R[i][j];  // squared length of the normal of both edges
      if (sine2 < kParallel * kParallel) continue;
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double apart = std::abs(t[i2] * R[i1][j] - t[i1] * R[i2][j]);
      const double shadows = a.half[i1] * absolute[i2][j] + a.half[i2] * absolute[i1][j] +
                             b.half[j1] * absolute[i][j2] + b.half[j2] * absolute[i][j1];
      most = std::max(most, (apart - shadows) / std::sqrt(sine2));
    }
  }
  // Two corners that face each other are farther apart than any of these axes shows.
  if (most > 0) {
    const double centers = model::length(between);
    const Vector3 d = (1 / centers) * between;
    if (centers > 0) most = std::max(most, centers - half_shadow(a, d) - half_shadow(b, d));
  }
  return most;
}

double distance(const OrientedBox& box, const Vector3& p_W) {
  const Vector3 arm = p_W - box.center_W;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double beyond = std::max(0.0, std::abs(dot(arm, box.axes_W[k])) - box.half[k]);
    sum += beyond * beyond;
  }
  return std::sqrt(sum);
}

bool contains(const OrientedBox& box, const Vector3& p_W) {
  const Vector3 arm = p_W - box.center_W;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(dot(arm, box.axes_W[k])) > box.half[k]) return false;
  }
  return true;
}

double share_inside(const OrientedBox& box, const std::vector<OrientedBox>& others) {
  constexpr std::array<double, 4> kMiddles{-0.75, -0.25, 0.25, 0.75};
  std::bitset<64> inside;
  const double size = diameter(box);
  for (const OrientedBox& other : others) {
    const Vector3 between = box.center_W - other.center_W;
    const double reach = (size + diameter(other)) / 2;
    if (dot(between, between) >= reach * reach) continue;
    // Along each axis of the other: the middle of the box, and half of each of its sides.
    std::array<double, 3> middle{};
    std::array<std::array<double, 3>, 3> sides{};
    bool is_near = true;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = dot(between, other.axes_W[k]);
      for (std::size_t i = 0; i < 3; ++i)
        sides[i][k] = box.half[i] * dot(box.axes_W[i], other.axes_W[k]);
      const double farthest = std::abs(sides[0][k]) + std::abs(sides[1][k]) + std::abs(sides[2][k]);
      is_near = is_near && std::abs(middle[k]) <= other.half[k] + kMiddles.back() * farthest;
    }
    if (!is_near) continue;
    for (std::size_t x = 0; x < 4; ++x) {
      for (std::size_t y = 0; y < 4; ++y) {
        // Of this row of parts, those between the two ends of the other box along each of its axes.
        double first = -1, last = 1;
        for (std::size_t k = 0; k < 3 && first <= last; ++k) {
          const double at = middle[k] + kMiddles[x] * sides[0][k] + kMiddles[y] * sides[1][k];
          const double a = (-other.half[k] - at) / sides[2][k];
          const double b = (other.half[k] - at) / sides[2][k];
          first = std::max(first, std::min(a, b));
          last = std::min(last, std::max(a, b));
        }
        for (std::size_t z = 0; z < 4; ++z) {
          if (first <= kMiddles[z] && kMiddles[z] <= last) inside.set(16 * x + 4 * y + z);
        }
      }
    }
  }
  return static_cast<double>(inside.count()) / static_cast<double>(inside.size());
}

double diameter(const OrientedBox& box) {
  return 2 * std::hypot(box.half[0], box.half[1], box.half[2]);
}

mesh::Bounds bounds_of(const OrientedBox& box) {
  const Vector3 reach{half_shadow(box, {1, 0, 0}), half_shadow(box, {0, 1, 0}),
                      half_shadow(box, {0, 0, 1})};
  return {box.center_W - reach, box.center_W + reach};
}

mesh::Bounds joined(const mesh::Bounds& a, const mesh::Bounds& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

double cover(const mesh::Bounds& a, const mesh::Bounds& b) {
  const Volumes v = volumes(a, b);
  return v.both / std::min(v.a, v.b);
}

double likeness(const mesh::Bounds& a, const mesh::Bounds& b) {
  const Volumes v = volumes(a, b);
  return v.both / (v.a + v.b - v.both);
}

}  // namespace rigor::robot
