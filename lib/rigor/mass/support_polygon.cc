// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/support_polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace rigor::mass {
namespace {

/// Above zero when c is left of the line from a to b.
double turn_on_ground(const GroundPoint& a, const GroundPoint& b, const GroundPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Adds the points' right-hand chain, without its last point, which begins the next chain.
template <class Iterator>
void add_chain(Iterator first, Iterator last, std::vector<GroundPoint>& corners) {
  const std::size_t begin = corners.size();
  for (; first != last; ++first) {
    while (corners.size() >= begin + 2 &&
           turn_on_ground(*(corners.end() - 2), corners.back(), *first) <= 0) {
      corners.pop_back();
    }
    corners.push_back(*first);
  }
  corners.pop_back();
}

double distance_to_side(const GroundPoint& a, const GroundPoint& b, const GroundPoint& p) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double square = x * x + y * y;
  const double share = square > 0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0;
  const double nearest = std::clamp(share, 0.0, 1.0);
  return std::hypot(p.x - a.x - nearest * x, p.y - a.y - nearest * y);
}

}  // namespace

SupportPolygon::SupportPolygon(std::vector<GroundPoint> contacts) {
  std::erase_if(contacts, [](const GroundPoint& p) { return !std::isfinite(p.x + p.y); });
  std::sort(contacts.begin(), contacts.end(), [](const GroundPoint& a, const GroundPoint& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  if (contacts.size() < 2) {
    corners_ = std::move(contacts);
    return;
  }
  add_chain(contacts.begin(), contacts.end(), corners_);
  add_chain(contacts.rbegin(), contacts.rend(), corners_);
}

double SupportPolygon::margin(const GroundPoint& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = corners_.size() >= 3;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const GroundPoint& a = corners_[i];
    const GroundPoint& b = corners_[(i + 1) % corners_.size()];
    nearest = std::min(nearest, distance_to_side(a, b, point));
    if (turn_on_ground(a, b, point) < 0) inside = false;
  }
  return inside ? nearest : -nearest;
}

}  // namespace rigor::mass
