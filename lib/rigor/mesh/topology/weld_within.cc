// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/weld_within.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace rigor::mesh {
namespace {

using Cell = std::array<double, 3>;  // whole numbers

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;  // bits of the golden ratio
    std::uint64_t hash = 0;
    for (const double side : cell) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(side + 0.0)) * kGolden;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// SparsePlaces that stay, in cubes as wide as the distance. They are further apart than that, so a cube
/// holds few.
class SparsePlaces {
 public:
  explicit SparsePlaces(double distance) : distance_(distance) {}

  /// The nearest place within the distance; p itself, which then stays, when there is none.
  Vector3 place_for(const Vector3& p) {
    const Cell home = cell(p);
    Vector3 best = p;
    double nearest = distance_;
    bool found = false;
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        for (const double z : {-1.0, 0.0, 1.0}) {
          const auto near = cells_.find({home[0] + x, home[1] + y, home[2] + z});
          if (near == cells_.end()) continue;
          for (const Vector3& place : near->second) {
            const double away = length(place - p);
            if (found ? away >= nearest : !(away <= nearest)) continue;
            best = place;
            nearest = away;
            found = true;
          }
        }
      }
    }
    if (!found) cells_[home].push_back(p);
    return best;
  }

 private:
  Cell cell(const Vector3& p) const {
    return {std::floor(p.x / distance_), std::floor(p.y / distance_), std::floor(p.z / distance_)};
  }

  double distance_;
  std::unordered_map<Cell, std::vector<Vector3>, CellHash> cells_;
};

bool finite(const Vector3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

std::uint64_t weld_within(TriangleMesh& mesh, double distance) {
  SparsePlaces places(distance);
  std::uint64_t moved = 0;
  for (Vector3& p : mesh.positions) {
    if (!finite(p)) continue;
    const Vector3 place = places.place_for(p);
    moved += place == p ? 0 : 1;
    p = place;
  }
  return moved;
}

}  // namespace rigor::mesh
