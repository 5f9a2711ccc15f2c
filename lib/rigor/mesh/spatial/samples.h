// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Places spread evenly over a surface, the same ones each time.
//
//   visit_samples(Bvh(mesh), 1000, [&](std::uint32_t slot, const Vector3& p) { return look(slot, p); });

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <rigor/mesh/spatial/bvh.h>

namespace rigor::mesh {

inline double surface_area(const Bvh& surface) {
  double sum = 0;
  for (std::uint32_t i = 0; i < surface.size(); ++i) sum += area(surface.facet(i));
  return sum;
}

/// The digits of i in base 2, mirrored at the point: 0, 1/2, 1/4, 3/4, … (J. van der Corput, 1935)
inline double radical_inverse(std::uint64_t i) {
  double result = 0;
  for (double digit = 0.5; i != 0; i >>= 1U, digit /= 2) {
    if ((i & 1U) != 0) result += digit;
  }
  return result;
}

/// Spreads (s, t) of the unit square evenly over the triangle (G. Turk, "Generating random points in
/// triangles", 1990).
inline Vector3 place_in(const Facet& f, double s, double t) {
  const double root = std::sqrt(s);
  return (1 - root) * f[0] + (root * (1 - t)) * f[1] + (root * t) * f[2];
}

/// All triangles' areas are laid end to end and cut into `count` equal pieces, with a sample in the
/// middle of each. Where the middle lies in its triangle's piece says how far from the first corner
/// the sample is, a van der Corput number on which side: in a triangle with many samples they are a
/// Hammersley set. Stops when `visit(slot, place)` returns false.
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
      if (!visit(slot, place_in(f, share, radical_inverse(next)))) return;
    }
    begin = end;
  }
}

template <class Visit>
void visit_corners(const Bvh& surface, const Visit& visit) {
  for (std::uint32_t slot = 0; slot < surface.size(); ++slot) {
    for (const Vector3& corner : surface.facet(slot)) {
      if (!visit(slot, corner)) return;
    }
  }
}

}  // namespace rigor::mesh
