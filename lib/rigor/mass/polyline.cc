// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/polyline.h>

#include <algorithm>
#include <cmath>

namespace rigor::mass {
namespace {

using model::Vector3;

struct Side {
  Vector3 from, to;
  std::size_t outline;
  std::size_t index;  // within its outline
};

/// z of the cross product: above zero when c is left of the line from a to b.
double turn_seen_from_above(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Outline seen_from(const Vector3& origin, const Outline& outline) {
  Outline seen;
  for (const Vector3& p : outline) seen.push_back(p - origin);
  return seen;
}

std::vector<Side> sides_of(const std::vector<Outline>& outlines) {
  std::vector<Side> sides;
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    const Outline& corners = outlines[o];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      sides.push_back({corners[i], corners[(i + 1) % corners.size()], o, i});
    }
  }
  return sides;
}

/// Whether a and b are not strictly on one side of the line through `side`.
bool straddle(const Vector3& a, const Vector3& b, const Side& side) {
  const double at_a = turn_seen_from_above(side.from, side.to, a);
  const double at_b = turn_seen_from_above(side.from, side.to, b);
  return !(at_a > 0 && at_b > 0) && !(at_a < 0 && at_b < 0);
}

bool apart(double a, double b, double c, double d) {
  return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

bool touch(const Side& s, const Side& t) {
  if (apart(s.from.y, s.to.y, t.from.y, t.to.y) || apart(s.from.x, s.to.x, t.from.x, t.to.x)) {
    return false;
  }
  return straddle(s.from, s.to, t) && straddle(t.from, t.to, s);
}

/// Neighbors share a corner. Where one runs back over the other, a third side touches one of them, or
/// there are but three sides and no area.
bool neighbors(const Side& s, const Side& t, const std::vector<Outline>& outlines) {
  if (s.outline != t.outline) return false;
  const std::size_t count = outlines[s.outline].size();
  return (s.index + 1) % count == t.index || (t.index + 1) % count == s.index;
}

/// Compares each side with those whose extent along x overlaps its own.
bool simple(const std::vector<Outline>& outlines) {
  std::vector<Side> sides = sides_of(outlines);
  const auto left = [](const Side& s) { return std::min(s.from.x, s.to.x); };
  std::sort(sides.begin(), sides.end(),
            [&](const Side& a, const Side& b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double right = std::max(sides[i].from.x, sides[i].to.x);
    for (std::size_t j = i + 1; j < sides.size() && left(sides[j]) <= right; ++j) {
      if (!neighbors(sides[i], sides[j], outlines) && touch(sides[i], sides[j])) return false;
    }
  }
  return true;
}

/// By the number of sides that a ray along x crosses.
bool contains(const Outline& outline, const Vector3& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3& a = outline[i];
    const Vector3& b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if ((turn_seen_from_above(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

/// ∫ dA, ∫ x, ∫ y, ∫ x², ∫ xy and ∫ y² dA.
struct AreaMoments {
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  void add(double sign, const AreaMoments& m) {
    area += sign * m.area;
    x += sign * m.x;
    y += sign * m.y;
    xx += sign * m.xx;
    xy += sign * m.xy;
    yy += sign * m.yy;
  }
};

/// Negative for a clockwise outline.
AreaMoments area_moments(const Outline& outline) {
  AreaMoments m;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3& a = outline[i];
    const Vector3& b = outline[(i + 1) % outline.size()];
    const double c = turn_seen_from_above({}, a, b);
    const double x = a.x + b.x;
    const double y = a.y + b.y;
    m.add(c / 24, {12, 4 * x, 4 * y, a.x * a.x + b.x * b.x + x * x, a.x * a.y + b.x * b.y + x * y,
                   a.y * a.y + b.y * b.y + y * y});
  }
  return m;
}

/// What is left when outlines within outlines are holes.
AreaMoments area_moments(const std::vector<Outline>& outlines) {
  AreaMoments sum;
  const std::vector<bool> turned = with_solid_on_the_right(outlines);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    sum.add(turned[i] ? -1 : 1, area_moments(outlines[i]));
  }
  return sum;
}

Solid prism(const AreaMoments& m, const Vector3& origin, double height) {
  const double x = m.x / m.area;
  const double y = m.y / m.area;
  const double xx = m.xx / m.area - x * x;
  const double yy = m.yy / m.area - y * y;
  const double zz = height * height / 12;
  return {m.area * height,
          {origin.x + x, origin.y + y, height / 2},
          {.ixx = yy + zz, .ixy = x * y - m.xy / m.area, .iyy = xx + zz, .izz = xx + yy}};
}

}  // namespace

std::optional<Solid> extruded(const std::vector<Outline>& outlines, double height) {
  if (!(height > 0) || !std::isfinite(height)) return std::nullopt;
  if (outlines.empty() || outlines.front().empty()) return std::nullopt;
  const Vector3 origin = outlines.front().front();
  std::vector<Outline> seen;
  std::size_t sides = 0;
  for (const Outline& outline : outlines) {
    for (const Vector3& p : outline) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return std::nullopt;
    }
    seen.push_back(corners_of(seen_from(origin, outline)));
    sides += seen.back().size();
    if (seen.back().size() < 3) return std::nullopt;
  }
  if (sides > kMaxSides || !simple(seen)) return std::nullopt;
  const Solid solid = prism(area_moments(seen), origin, height);
  if (!(solid.volume > 0) || !std::isfinite(solid.volume)) return std::nullopt;
  return solid;
}

Outline corners_of(const Outline& outline) {
  Outline corners;
  for (const Vector3& p : outline) {
    const Vector3 flat{p.x, p.y, 0};
    if (corners.empty() || flat != corners.back()) corners.push_back(flat);
  }
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

std::vector<bool> with_solid_on_the_right(const std::vector<Outline>& outlines) {
  std::vector<bool> turned(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    bool hole = false;
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      if (j != i && contains(outlines[j], outlines[i].front())) hole = !hole;
    }
    turned[i] = hole == (area_moments(outlines[i]).area > 0);
  }
  return turned;
}

std::optional<Solid> solid_of(const model::Polyline& polyline) {
  Outline outline;
  for (const auto& point : polyline.points) outline.push_back(point.value);
  return extruded({outline}, polyline.height.value);
}

}  // namespace rigor::mass
