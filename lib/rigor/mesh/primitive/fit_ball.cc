// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// At most four points carry the smallest ball. Starting from one, the farthest point that is outside
// joins those that carry; among them and it the smallest ball is found by trying each subset (in the
// manner of B. Gärtner, "Fast and robust smallest enclosing balls", 1999). The radius grows with each
// step, so no set of carriers comes twice.

#include <rigor/mesh/primitive/fit_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rigor::mesh {
namespace {

/// A point no farther outside than this share of the radius is on the ball: some roundings.
constexpr double kOnBall = 1e-12;

/// Real hulls take about ten steps; what is left to gain after so many is rounding.
constexpr int kMaxRounds = 1000;

/// Of the determinant of unit vectors: flatter subsets are carried by fewer points.
constexpr double kFlatSubset = 1e-12;

double squared(const Vector3& v) { return dot(v, v); }

/// The smallest ball with all these points on it, when they are two to four and not degenerate.
std::optional<Ball> ball_through(const std::vector<Vector3>& on) {
  const Vector3& o = on.front();
  if (on.size() == 1) return Ball{o, 0};
  const Vector3 a = on[1] - o;
  if (on.size() == 2) return Ball{o + 0.5 * a, 0.5 * length(a)};
  const Vector3 b = on[2] - o;
  const Vector3 n = cross(a, b);
  if (squared(n) <= kFlatSubset * squared(a) * squared(b)) return std::nullopt;
  Vector3 center;
  if (on.size() == 3) {
    center = (0.5 / squared(n)) * (squared(a) * cross(b, n) + squared(b) * cross(n, a));
  } else {
    const Vector3 c = on[3] - o;
    const double d = dot(n, c);
    if (std::abs(d) <= kFlatSubset * length(a) * length(b) * length(c)) return std::nullopt;
    center = (0.5 / d) * (squared(a) * cross(b, c) + squared(b) * cross(c, a) + squared(c) * n);
  }
  return Ball{o + center, length(center)};
}

bool ball_holds(const Ball& ball, const std::vector<Vector3>& points) {
  const double limit = ball.radius * (1 + kOnBall);
  return std::all_of(points.begin(), points.end(),
                     [&ball, limit](const Vector3& p) { return length(p - ball.center) <= limit; });
}

struct Carried {
  Ball ball;
  std::vector<Vector3> by;
};

/// The smallest ball around up to five points, the last of which it carries.
std::optional<Carried> smallest_carried(const std::vector<Vector3>& points) {
  const std::size_t others = points.size() - 1;
  std::optional<Carried> best;
  for (std::uint32_t subset = 0; subset < 1U << others; ++subset) {
    std::vector<Vector3> by = {points.back()};
    for (std::size_t i = 0; i < others; ++i) {
      if ((subset >> i & 1U) != 0) by.push_back(points[i]);
    }
    if (by.size() > 4) continue;
    const auto ball = ball_through(by);
    if (!ball || (best && ball->radius >= best->ball.radius)) continue;
    if (ball_holds(*ball, points)) best = Carried{*ball, by};
  }
  return best;
}

const Vector3& farthest_from(const std::vector<Vector3>& points, const Vector3& from) {
  return *std::max_element(points.begin(), points.end(), [&from](const auto& a, const auto& b) {
    return squared(a - from) < squared(b - from);
  });
}

}  // namespace

Ball enclosing_ball(const std::vector<Vector3>& points) {
  if (points.empty()) return {};
  Carried carried{{points.front(), 0}, {points.front()}};
  for (int step = 0; step < kMaxRounds; ++step) {
    const Vector3& far = farthest_from(points, carried.ball.center);
    if (length(far - carried.ball.center) <= carried.ball.radius * (1 + kOnBall)) break;
    std::vector<Vector3> candidates = carried.by;
    candidates.push_back(far);
    auto grown = smallest_carried(candidates);
    if (!grown || grown->ball.radius <= carried.ball.radius) break;  // only roundings apart
    carried = std::move(*grown);
  }
  const Vector3& far = farthest_from(points, carried.ball.center);
  return {carried.ball.center, length(far - carried.ball.center)};
}

}  // namespace rigor::mesh
