// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/substitute/fitted.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <rigor/mesh/spatial/bvh.h>
#include <rigor/mesh/spatial/distance.h>
#include <rigor/mesh/spatial/samples.h>

namespace rigor::mesh {
namespace {

/// On each surface, besides corners: for each triangle of the coarse one some, and so many at most.
constexpr std::size_t kTriangleSamples = 30;
constexpr std::size_t kMostSamples = 3000;
constexpr int kFitRounds = 24;
/// After so many rounds places that are far count more than before: first the mean gets less, then the greatest.
constexpr int kRoundsOfAPower = 8;
/// What is farther off after the first of them than so many times what is near enough will not get there.
constexpr double kHopeless = 4;
/// Of the mean pull: corners are pulled by the places between them that are farthest, so the whole of it is too far.
constexpr double kPullStep = 0.5;

/// Shares of the corners in a place of a triangle: they sum to one.
std::array<double, 3> corner_shares(const Facet& f, const Vector3& p) {
  const Vector3 normal = cross(f[1] - f[0], f[2] - f[0]);
  const double size = dot(normal, normal);
  if (!(size > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const double b = dot(normal, cross(f[0] - f[2], p - f[2])) / size;
  const double c = dot(normal, cross(f[1] - f[0], p - f[0])) / size;
  return {1 - b - c, b, c};
}

/// How corners are to move, as a mean over the places around them, where far ones count more: by a power of their
/// distance.
class Pull {
 public:
  Pull(std::size_t corners, int power) : power_(power), sum_(corners), weight_(corners) {}

  void add(const Triangle& t, const std::array<double, 3>& shares, const Vector3& by) {
    const double distance = length(by);
    double far = distance;
    for (int i = 1; i < power_; ++i) far *= distance;
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = shares[k] * far;
      if (!(weight > 0)) continue;
      sum_[t[k]] = sum_[t[k]] + weight * by;
      weight_[t[k]] += weight;
    }
  }

  void apply(std::vector<Vector3>& positions) const {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (weight_[i] > 0) positions[i] = positions[i] + (kPullStep / weight_[i]) * sum_[i];
    }
  }

 private:
  int power_;
  std::vector<Vector3> sum_;
  std::vector<double> weight_;
};

/// One round: towards the places of the fine surface, and away from where it has none.
TriangleMesh pulled(TriangleMesh coarse, const Bvh& fine, std::size_t samples, int power) {
  const Bvh tree(coarse);
  if (tree.size() == 0) return coarse;
  Pull pull(coarse.positions.size(), power);
  std::uint32_t guess = 0;
  const auto pull_to = [&](std::uint32_t, const Vector3& p) {
    const Nearest near = tree.nearest(p, guess);
    guess = near.slot;
    pull.add(coarse.triangles[tree.index(near.slot)], corner_shares(tree.facet(near.slot), near.at),
             p - near.at);
    return true;
  };
  visit_corners(fine, pull_to);
  visit_samples(fine, samples, pull_to);
  guess = 0;
  visit_samples(tree, samples, [&](std::uint32_t slot, const Vector3& p) {
    const Nearest near = fine.nearest(p, guess);
    guess = near.slot;
    pull.add(coarse.triangles[tree.index(slot)], corner_shares(tree.facet(slot), p), near.at - p);
    return true;
  });
  pull.apply(coarse.positions);
  return coarse;
}

}  // namespace

TriangleMesh fitted(TriangleMesh coarse, const TriangleMesh& fine, double enough) {
  const Bvh tree(fine);
  if (tree.size() == 0) return coarse;
  const std::size_t samples = std::min(kMostSamples, kTriangleSamples * coarse.triangles.size());
  double least = deviation(coarse, fine, samples).hausdorff();
  TriangleMesh moved = coarse;
  for (int round = 0; round < kFitRounds && least > enough; ++round) {
    if (round == kRoundsOfAPower && enough > 0 && least > kHopeless * enough) break;
    moved = pulled(std::move(moved), tree, samples, 1 + round / kRoundsOfAPower);
    const double error = deviation(moved, fine, samples).hausdorff();
    if (!(error < least)) continue;
    least = error;
    coarse = moved;
  }
  return coarse;
}

}  // namespace rigor::mesh
