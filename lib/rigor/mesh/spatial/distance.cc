// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/distance.h>

#include <cmath>
#include <limits>

#include <rigor/mesh/spatial/bvh.h>
#include <rigor/mesh/spatial/samples.h>

namespace rigor::mesh {
namespace {

struct Farthest {
  double distance = 0;
  bool complete = true;
};

Farthest farthest_apart(const Bvh& from, const Bvh& to, std::size_t samples) {
  if (from.size() == 0) return {};
  if (to.size() == 0) return {std::numeric_limits<double>::infinity()};
  Farthest result;
  std::uint64_t looks = 0;
  std::uint32_t guess = 0;  // neighbors follow each other: what was next to one is near the other
  const auto look = [&](std::uint32_t, const Vector3& p) {
    const Nearest near = to.nearest(p, guess, result.distance);
    guess = near.slot;
    looks += near.looks;
    result.distance = std::max(result.distance, near.distance);
    result.complete = looks <= kMaxDeviationLooks;
    return result.complete;
  };
  visit_corners(from, look);
  if (result.complete && samples > 0) visit_samples(from, samples, look);
  return result;
}

}  // namespace

Deviation deviation(const TriangleMesh& a, const TriangleMesh& b, std::size_t samples) {
  const Bvh tree_a(a);
  const Bvh tree_b(b);
  const std::size_t count = std::min(samples, kMaxSamples);
  const Farthest from_a = farthest_apart(tree_a, tree_b, count);
  const Farthest from_b = farthest_apart(tree_b, tree_a, count);
  const double each = std::max(surface_area(tree_a), surface_area(tree_b)) /
                      static_cast<double>(std::max<std::size_t>(count, 1));
  return {from_a.distance, from_b.distance, std::sqrt(each),
          from_a.complete && from_b.complete && count == samples};
}

}  // namespace rigor::mesh
