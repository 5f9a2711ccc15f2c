// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/distance.h>

#include <cmath>
#include <limits>

#include <rigor/mesh/spatial/bvh.h>

namespace rigor::mesh {
namespace {

double surface_area(const Bvh& surface) {
  double sum = 0;
  for (std::uint32_t i = 0; i < surface.size(); ++i) sum += area(surface.facet(i));
  return sum;
}

/// The digits of i in base 2, mirrored at the point: 0, 1/2, 1/4, 3/4, … (J. van der Corput, 1935)
double radical_inverse(std::uint64_t i) {
  double result = 0;
  for (double digit = 0.5; i != 0; i >>= 1U, digit /= 2) {
    if ((i & 1U) != 0) result += digit;
  }
  return result;
}

/// Spreads (s, t) of the unit square evenly over the triangle (G. Turk, "Generating random points in
/// triangles", 1990).
Vector3 place_in(const Facet& f, double s, double t) {
  const double root = std::sqrt(s);
  return (1 - root) * f[0] + (root * (1 - t)) * f[1] + (root * t) * f[2];
}

/// All triangles' areas are laid end to end and cut into `count` equal pieces, with a sample in the
/// middle of each. Where the middle lies in its triangle's piece says how far from the first corner
/// the sample is, a van der Corput number on which side: in a triangle with many samples they are a
/// Hammersley set. Stops when `visit(place)` returns false.
template <class Visit>
void visit_samples(const Bvh& surface, std::size_t count, const Visit& visit) {
  const double piece = surface_area(surface) / static_cast<double>(count);
  if (!(piece > 0)) return;
  double begin = 0;  // of this triangle's area
  std::size_t next = 0;
  for (std::uint32_t slot = 0; slot < surface.size(); ++slot) {
    const Facet& f = surface.facet(slot);
    const double end = begin + area(f);
    for (; next < count; ++next) {
      const double at = (static_cast<double>(next) + 0.5) * piece;
      if (at >= end) break;
      const double share = std::max(0.0, (at - begin) / (end - begin));
      if (!visit(place_in(f, share, radical_inverse(next)))) return;
    }
    begin = end;
  }
}

template <class Visit>
void visit_corners(const Bvh& surface, const Visit& visit) {
  for (std::uint32_t slot = 0; slot < surface.size(); ++slot) {
    for (const Vector3& corner : surface.facet(slot)) {
      if (!visit(corner)) return;
    }
  }
}

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
  const auto look = [&](const Vector3& p) {
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
