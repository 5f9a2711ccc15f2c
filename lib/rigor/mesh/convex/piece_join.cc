// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/piece_join.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/primitive/principal_axes.h>

namespace rigor::mesh {
namespace {

/// Up to so many, each pair's common hull is computed; of more, the smallest go first to the neighbor
/// that their common bounds favor. Two hundred of a damaged mesh took ten seconds.
constexpr std::size_t kMaxPaired = 120;

/// Points of all pairs' common hulls together: some seconds. Hulls of a robot's mesh have fifty, two hundred of a
/// damaged one had a thousand each.
constexpr std::size_t kMaxPairedPoints = 4'000'000;

constexpr double kFar = std::numeric_limits<double>::infinity();

Hull joined(const Hull& a, const Hull& b) {
  std::vector<Vector3> points = a.mesh.positions;
  points.insert(points.end(), b.mesh.positions.begin(), b.mesh.positions.end());
  auto hull = convex_hull(points);
  if (!hull) return {{}, kFar};
  const double volume = enclosed_volume(*hull);
  return {std::move(*hull), volume};
}

double common_bounds(const Hull& a, const Hull& b) {
  const Bounds p = bounds_of(a.mesh.positions);
  const Bounds q = bounds_of(b.mesh.positions);
  return length(
      Vector3{std::max(p.max.x, q.max.x), std::max(p.max.y, q.max.y), std::max(p.max.z, q.max.z)} -
      Vector3{std::min(p.min.x, q.min.x), std::min(p.min.y, q.min.y), std::min(p.min.z, q.min.z)});
}

void join_smallest(std::vector<Hull>& hulls) {
  const auto by_volume = [](const Hull& a, const Hull& b) { return a.volume < b.volume; };
  std::iter_swap(std::min_element(hulls.begin(), hulls.end(), by_volume), hulls.end() - 1);
  const Hull smallest = std::move(hulls.back());
  hulls.pop_back();
  const auto nearest =
      std::min_element(hulls.begin(), hulls.end(), [&](const Hull& a, const Hull& b) {
        return common_bounds(smallest, a) < common_bounds(smallest, b);
      });
  *nearest = joined(*nearest, smallest);
}

bool too_many_pairs(const std::vector<Hull>& hulls) {
  if (hulls.size() > kMaxPaired) return true;
  std::size_t points = 0;
  for (const Hull& hull : hulls) points += hull.mesh.positions.size();
  return (hulls.size() - 1) * points > kMaxPairedPoints;
}

/// What joining costs, of each pair.
class Costs {
 public:
  explicit Costs(const std::vector<Hull>& hulls) : rows_(hulls.size()) {
    for (std::size_t i = 0; i < hulls.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) rows_[i].push_back(cost(hulls[i], hulls[j]));
    }
  }

  struct Pair {
    std::size_t later = 0;
    std::size_t earlier = 0;
    double cost = kFar;
  };

  Pair least() const {
    Pair best;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (rows_[i][j] < best.cost) best = {i, j, rows_[i][j]};
      }
    }
    return best;
  }

  /// The later one is gone, the earlier one is new.
  void update(const std::vector<Hull>& hulls, const Pair& pair) {
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(pair.later));
    for (std::size_t i = pair.later; i < rows_.size(); ++i) {
      rows_[i].erase(rows_[i].begin() + static_cast<std::ptrdiff_t>(pair.later));
    }
    const std::size_t k = pair.earlier;
    for (std::size_t i = 0; i < hulls.size(); ++i) {
      if (i != k) rows_[std::max(i, k)][std::min(i, k)] = cost(hulls[i], hulls[k]);
    }
  }

 private:
  static double cost(const Hull& a, const Hull& b) {
    return joined(a, b).volume - a.volume - b.volume;
  }

  std::vector<std::vector<double>> rows_;
};

}  // namespace

void join_hulls(std::vector<Hull>& hulls, std::size_t count, double free) {
  while (hulls.size() > count && too_many_pairs(hulls)) join_smallest(hulls);
  Costs costs(hulls);
  while (hulls.size() > 1) {
    const Costs::Pair pair = costs.least();
    if (pair.cost == kFar || (hulls.size() <= count && pair.cost > free)) return;
    hulls[pair.earlier] = joined(hulls[pair.earlier], hulls[pair.later]);
    hulls.erase(hulls.begin() + static_cast<std::ptrdiff_t>(pair.later));
    costs.update(hulls, pair);
  }
}

}  // namespace rigor::mesh
