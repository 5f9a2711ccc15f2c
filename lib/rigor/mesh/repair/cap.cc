// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Loops are traced; each hole is tied to the outline round it by an edge there and back; then ears are
// cut off (D. Eberly, "Triangulation by ear clipping", 1998).

#include <rigor/mesh/repair/cap.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include <rigor/mesh/primitive/fit_axis.h>
#include <rigor/mesh/spatial/plane_point.h>

namespace rigor::mesh {
namespace {

/// Corners seen while ears are looked for, which take nanoseconds each: then the rest becomes a fan.
constexpr std::uint64_t kMaxEarLooks = 20'000'000;

using Loop = std::vector<std::uint32_t>;

class Capper {
 public:
  Capper(const std::vector<DirectedEdge>& edges, const std::vector<Vector3>& positions,
         const Vector3& normal)
      : points_(positions.size()) {
    const Basis basis = basis_about(normal);
    for (const auto& [from, to] : edges) {
      const Vector3& p = positions[from];
      points_[from] = {dot(basis[0], p), dot(basis[1], p)};
      const Vector3& q = positions[to];
      points_[to] = {dot(basis[0], q), dot(basis[1], q)};
    }
  }

  std::vector<Triangle> run(const std::vector<DirectedEdge>& edges) {
    std::vector<Loop> outlines;
    std::vector<Loop> holes;
    for (Loop& loop : loops_of(edges))
      (area(loop) < 0 ? holes : outlines).push_back(std::move(loop));
    // From the right, so that what a hole is tied to lies on its right.
    std::stable_sort(holes.begin(), holes.end(), [this](const Loop& a, const Loop& b) {
      return point(rightmost(a)).x > point(rightmost(b)).x;
    });
    for (const Loop& hole : holes) {
      Loop* around = smallest_around(outlines, point(rightmost(hole)));
      if (around == nullptr || !tie(*around, hole)) cut_ears(hole);
    }
    for (const Loop& outline : outlines) cut_ears(outline);
    return std::move(triangles_);
  }

 private:
  const PlanePoint& point(std::uint32_t i) const { return points_[i]; }

  /// Twice the area of the triangle; positive when c is left of the line from a to b.
  double side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const PlanePoint& p = point(a);
    const PlanePoint& q = point(b);
    const PlanePoint& r = point(c);
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  double area(const Loop& loop) const {
    double sum = 0;
    for (std::size_t i = 2; i < loop.size(); ++i) sum += side(loop[0], loop[i - 1], loop[i]);
    return sum;
  }

  std::uint32_t rightmost(const Loop& loop) const {
    return *std::max_element(loop.begin(), loop.end(), [this](std::uint32_t a, std::uint32_t b) {
      return point(a).x < point(b).x;
    });
  }

  std::vector<Loop> loops_of(std::vector<DirectedEdge> edges) const {
    std::sort(edges.begin(), edges.end());
    std::vector<bool> used(edges.size(), false);
    std::vector<Loop> loops;
    for (std::size_t first = 0; first < edges.size(); ++first) {
      if (used[first]) continue;
      Loop loop;
      std::size_t at = first;
      while (at < edges.size()) {
        used[at] = true;
        loop.push_back(edges[at][0]);
        if (edges[at][1] == edges[first][0]) break;
        at = next(edges, used, at);
      }
      if (at < edges.size() && loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
  }

  /// Where several lead on, the one most to the left, so that areas that touch in a corner stay apart.
  std::size_t next(const std::vector<DirectedEdge>& edges, const std::vector<bool>& used,
                   std::size_t at) const {
    const auto [from, through] = edges[at];
    const PlanePoint p = point(from);
    const PlanePoint q = point(through);
    std::size_t best = edges.size();
    double most = 0;
    auto i = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{through, 0}) - edges.begin();
    for (auto k = static_cast<std::size_t>(i); k < edges.size() && edges[k][0] == through; ++k) {
      if (used[k]) continue;
      const PlanePoint r = point(edges[k][1]);
      const double angle = std::atan2(cross(q - p, r - q), dot(q - p, r - q));
      if (best == edges.size() || angle > most) {
        best = k;
        most = angle;
      }
    }
    return best;
  }

  bool inside(const Loop& loop, const PlanePoint& p) const {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlanePoint a = point(loop[i]);
      const PlanePoint b = point(loop[(i + 1) % loop.size()]);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
  }

  Loop* smallest_around(std::vector<Loop>& outlines, const PlanePoint& p) const {
    Loop* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (Loop& outline : outlines) {
      const double size = area(outline);
      if (size >= least || !inside(outline, p)) continue;
      least = size;
      best = &outline;
    }
    return best;
  }

  /// From the hole's rightmost corner to one of the outline that it sees. False when it sees none.
  bool tie(Loop& outline, const Loop& hole) const {
    const std::uint32_t from = rightmost(hole);
    const auto corner = visible(outline, from);
    if (!corner) return false;
    Loop tied(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(*corner) + 1);
    const auto start = std::find(hole.begin(), hole.end(), from);
    tied.insert(tied.end(), start, hole.end());
    tied.insert(tied.end(), hole.begin(), start);
    tied.push_back(from);
    tied.insert(tied.end(), outline.begin() + static_cast<std::ptrdiff_t>(*corner), outline.end());
    outline = std::move(tied);
    return true;
  }

  /// The first edge to the right of m is hit at h; its right end is seen unless a corner lies in the
  /// triangle between, and then that of least angle is.
  std::optional<std::size_t> visible(const Loop& loop, std::uint32_t from) const {
    const PlanePoint m = point(from);
    double hit = std::numeric_limits<double>::infinity();
    std::size_t end = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t j = (i + 1) % loop.size();
      const PlanePoint a = point(loop[i]);
      const PlanePoint b = point(loop[j]);
      if (a.y > m.y || b.y < m.y || a.y == b.y) continue;  // only upward edges have their left here
      const double x = a.x + (m.y - a.y) / (b.y - a.y) * (b.x - a.x);
      if (x < m.x || x >= hit) continue;
      hit = x;
      end = a.x > b.x ? i : j;
    }
    if (hit == std::numeric_limits<double>::infinity()) return std::nullopt;
    const PlanePoint e = point(loop[end]);
    double least = std::abs(e.y - m.y) / std::max(e.x - m.x, std::numeric_limits<double>::min());
    std::size_t best = end;
    const double way = e.y < m.y ? -1 : 1;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlanePoint p = point(loop[i]);
      const PlanePoint h{hit, m.y};
      if (p.x <= m.x || way * turn(m, h, p) < 0 || way * turn(h, e, p) < 0 ||
          way * turn(e, m, p) < 0) {
        continue;
      }
      const double slope = std::abs(p.y - m.y) / (p.x - m.x);
      if (slope >= least || !opens_to(loop, i, m)) continue;
      least = slope;
      best = i;
    }
    return best;
  }

  /// Whether the point is seen from the corner between its two edges; corners that were tied come twice.
  bool opens_to(const Loop& loop, std::size_t i, const PlanePoint& m) const {
    const PlanePoint p = point(loop[(i + loop.size() - 1) % loop.size()]);
    const PlanePoint c = point(loop[i]);
    const PlanePoint n = point(loop[(i + 1) % loop.size()]);
    const auto left = [](const PlanePoint& a, const PlanePoint& b, const PlanePoint& q) {
      return turn(a, b, q) > 0;
    };
    return left(p, c, n) ? left(p, c, m) && left(c, n, m) : left(p, c, m) || left(c, n, m);
  }

  /// Whether no other corner is in the triangle at `at`.
  bool is_ear(const Loop& loop, std::size_t at) {
    const std::size_t n = loop.size();
    const std::uint32_t a = loop[(at + n - 1) % n];
    const std::uint32_t b = loop[at];
    const std::uint32_t c = loop[(at + 1) % n];
    if (side(a, b, c) <= 0) return false;
    for (const std::uint32_t p : loop) {
      ++looks_;
      if (p == a || p == b || p == c) continue;
      if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) return false;
    }
    return true;
  }

  void cut_ears(Loop loop) {
    std::size_t at = 0;
    std::size_t tried = 0;
    while (loop.size() > 3 && tried < loop.size() && looks_ < kMaxEarLooks) {
      at %= loop.size();
      if (!is_ear(loop, at)) {
        ++at;
        ++tried;
        continue;
      }
      const std::size_t n = loop.size();
      triangles_.push_back({loop[(at + n - 1) % n], loop[at], loop[(at + 1) % n]});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    for (std::size_t i = 2; i < loop.size(); ++i)
      triangles_.push_back({loop[0], loop[i - 1], loop[i]});
  }

  std::vector<PlanePoint> points_;  // in the plane, of the positions that edges name
  std::vector<Triangle> triangles_;
  std::uint64_t looks_ = 0;
};

}  // namespace

std::vector<Triangle> cap_of(const std::vector<DirectedEdge>& edges,
                             const std::vector<Vector3>& positions, const Vector3& normal) {
  return Capper(edges, positions, normal).run(edges);
}

}  // namespace rigor::mesh
