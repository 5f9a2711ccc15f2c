// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/loop_filling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <rigor/mesh/spatial/plane_point.h>
#include <rigor/mesh/topology/thinness.h>

namespace rigor::mesh {
namespace {

/// Bends closer than this are as good as each other, so that the size decides on flat ground.
constexpr double kBendStep = std::numbers::pi / 18;

Vector3 normal(const Facet& f) {
  const Vector3 n = area_vector(f);
  const double size = length(n);
  return size > 0 ? (1 / size) * n : Vector3{};
}

/// In steps; of a triangle without a normal, none.
int bend(const Vector3& a, const Vector3& b) {
  if (a == Vector3{} || b == Vector3{}) return 0;
  return static_cast<int>(std::lround(std::acos(std::clamp(dot(a, b), -1.0, 1.0)) / kBendStep));
}

/// What is wrong with a filling, the worst first.
struct Cost {
  int taken = 0;    ///< edges that the mesh has already
  int thin = 0;     ///< slivers and lines
  int bend = 0;     ///< the sharpest, in steps
  double size = 0;  ///< sum of squared longest edges: small for small areas and round triangles

  void add(const Cost& other) {
    taken += other.taken;
    thin += other.thin;
    bend = std::max(bend, other.bend);
    size += other.size;
  }
  bool operator<(const Cost& other) const {
    return std::tie(taken, thin, bend, size) <
           std::tie(other.taken, other.thin, other.bend, other.size);
  }
};

/// By dynamic programming over the stretches of the loop from i to k: the triangle at the chord that
/// closes a stretch parts it in two.
class BestFilling {
 public:
  BestFilling(const Workpiece& work, const Hole& hole)
      : work_(work), hole_(hole), n_(hole.vertices.size()), cells_(n_ * n_) {}

  std::vector<Triangle> run() {
    for (std::size_t i = 0; i + 1 < n_; ++i) cell(i, i + 1).normal = outside(i);
    for (std::size_t width = 2; width < n_; ++width) {
      for (std::size_t i = 0; i + width < n_; ++i) part(i, i + width);
    }
    return collect();
  }

 private:
  struct Cell {
    Cost cost;
    std::size_t apex = 0;
    Vector3 normal;  // of the triangle at the chord, on the stretch's side
  };

  Cell& cell(std::size_t i, std::size_t k) { return cells_[i * n_ + k]; }
  Vector3 outside(std::size_t edge) const { return normal(work_.facet_of(hole_.faces[edge])); }
  const Vector3& at(std::size_t i) const { return work_.at(hole_.vertices[i]); }

  void part(std::size_t i, std::size_t k) {
    const bool last = i == 0 && k + 1 == n_;
    const bool taken = !last && work_.faces_at(hole_.vertices[i], hole_.vertices[k]).count > 0;
    Cell& best = cell(i, k);
    best.cost.taken = std::numeric_limits<int>::max();
    for (std::size_t j = i + 1; j < k; ++j) {
      Cell tried = with(i, j, k);
      if (last) tried.cost.bend = std::max(tried.cost.bend, bend(tried.normal, outside(k)));
      if (taken) ++tried.cost.taken;
      if (tried.cost < best.cost) best = tried;
    }
  }

  Cell with(std::size_t i, std::size_t j, std::size_t k) {
    const Facet f{at(i), at(j), at(k)};
    const Cell& left = cell(i, j);
    const Cell& right = cell(j, k);
    const Thinness thin = thinness(f);
    Cell whole{{}, j, thin == Thinness::kLine ? Vector3{} : normal(f)};
    whole.cost.add(left.cost);
    whole.cost.add(right.cost);
    whole.cost.thin += thin == Thinness::kNone ? 0 : 1;
    whole.cost.bend = std::max(
        {whole.cost.bend, bend(whole.normal, left.normal), bend(whole.normal, right.normal)});
    const auto square = [](const Vector3& v) { return dot(v, v); };
    whole.cost.size += std::max({square(f[1] - f[0]), square(f[2] - f[1]), square(f[0] - f[2])});
    return whole;
  }

  std::vector<Triangle> collect() {
    std::vector<Triangle> filling;
    std::vector<std::array<std::size_t, 2>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k < i + 2) continue;
      const std::size_t j = cell(i, k).apex;
      filling.push_back({hole_.vertices[i], hole_.vertices[j], hole_.vertices[k]});
      open.push_back({i, j});
      open.push_back({j, k});
    }
    return filling;
  }

  const Workpiece& work_;
  const Hole& hole_;
  std::size_t n_;
  std::vector<Cell> cells_;
};

/// The loop seen along its area vector.
std::vector<PlanePoint> flattened(const Workpiece& work, const Hole& hole) {
  const Vector3& origin = work.at(hole.vertices[0]);
  Vector3 area;
  for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
    const std::uint32_t next = hole.vertices[(i + 1) % hole.vertices.size()];
    area = area + cross(work.at(hole.vertices[i]) - origin, work.at(next) - origin);
  }
  const Vector3 aside = std::abs(area.x) < std::abs(area.y) ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  const Vector3 u = cross(aside, area);
  const Vector3 v = cross(area, u);
  const double u_size = length(u);
  const double v_size = length(v);
  std::vector<PlanePoint> points;
  for (const std::uint32_t vertex : hole.vertices) {
    const Vector3 p = work.at(vertex) - origin;
    points.push_back({dot(p, u) / u_size, dot(p, v) / v_size});
  }
  return points;
}

/// Cuts off the ear with the shortest chord, again and again. (G. Meisters, "Polygons have ears", 1975.)
class EarFilling {
 public:
  EarFilling(const Workpiece& work, const Hole& hole)
      : work_(work), hole_(hole), points_(flattened(work, hole)) {
    for (std::size_t i = 0; i < points_.size(); ++i) left_.push_back(i);
    for (std::size_t k = 0; k < left_.size(); ++k) chord_.push_back(chord(k));
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> filling;
    while (left_.size() > 3) {
      const auto ear = std::min_element(chord_.begin(), chord_.end());
      if (!(*ear < kNoEar)) return {};
      const auto k = static_cast<std::size_t>(ear - chord_.begin());
      filling.push_back(triangle(k));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
      chord_.erase(ear);
      chord_[k % left_.size()] = chord(k % left_.size());
      chord_[before(k)] = chord(before(k));
    }
    filling.push_back(triangle(1));
    return filling;
  }

 private:
  static constexpr double kNoEar = std::numeric_limits<double>::infinity();

  std::size_t before(std::size_t k) const { return (k + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t k) const { return (k + 1) % left_.size(); }

  Triangle triangle(std::size_t k) const {
    return {hole_.vertices[left_[before(k)]], hole_.vertices[left_[k]],
            hole_.vertices[left_[after(k)]]};
  }

  /// Length of the chord that cuts off the corner k, if that is an ear.
  double chord(std::size_t k) const {
    const PlanePoint& a = points_[left_[before(k)]];
    const PlanePoint& b = points_[left_[k]];
    const PlanePoint& c = points_[left_[after(k)]];
    if (!(turn(a, b, c) > 0)) return kNoEar;
    for (const std::size_t other : left_) {
      if (other == left_[before(k)] || other == left_[k] || other == left_[after(k)]) continue;
      const PlanePoint& p = points_[other];
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return kNoEar;
    }
    const Triangle t = triangle(k);
    if (work_.faces_at(t[0], t[2]).count > 0) return kNoEar;
    return length(work_.at(t[0]) - work_.at(t[2]));
  }

  const Workpiece& work_;
  const Hole& hole_;
  std::vector<PlanePoint> points_;
  std::vector<std::size_t> left_;  // corners not cut off
  std::vector<double> chord_;
};

}  // namespace

std::vector<Triangle> best_filling(const Workpiece& work, const Hole& hole) {
  return BestFilling(work, hole).run();
}

std::vector<Triangle> ear_filling(const Workpiece& work, const Hole& hole) {
  return EarFilling(work, hole).run();
}

}  // namespace rigor::mesh
