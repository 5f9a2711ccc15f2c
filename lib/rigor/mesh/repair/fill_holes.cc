// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/fill_holes.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <rigor/mesh/repair/clean.h>
#include <rigor/mesh/repair/loop_filling.h>
#include <rigor/mesh/topology/holes.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

// Holes that touch get their turn when the first of them is filled.
constexpr int kMaxFillingRounds = 4;

/// Triangles examined for best fillings: two seconds. After that ears must do.
constexpr std::uint64_t kMaxBestWork = 10'000'000;

/// A filling that has this share of the area of the patch that it would close is the other side of a
/// sheet; the base of a cone that is not flat as a plate has less.
constexpr double kSheetShare = 0.9;

double mesh_area(const Workpiece& work) {
  double sum = 0;
  for (std::uint32_t face = 0; face < work.size(); ++face) {
    if (work.has(face)) sum += area(work.facet_of(face));
  }
  return sum;
}

struct Filling {
  Hole hole;
  std::vector<Triangle> triangles;
  double area = 0;
};

class Filler {
 public:
  Filler(Workpiece& work, const HoleLimits& limits) : work_(work), limits_(limits) {}

  HolesFilled run() {
    done_.mesh_area = mesh_area(work_);
    for (int round = 0; round < kMaxFillingRounds && !work_.tired(); ++round) {
      if (!fill_all()) break;
    }
    return done_;
  }

 private:
  /// Returns whether any was filled.
  bool fill_all() {
    done_.too_large = 0;
    done_.left = 0;
    const std::uint64_t before = done_.filled;
    measure_patches();
    for (const Filling& filling : fillings()) {
      if (!fits(filling)) {
        ++done_.too_large;
      } else if (work_.tired() || !fill(filling)) {
        ++done_.left;
      }
    }
    return done_.filled > before;
  }

  std::vector<Filling> fillings() {
    std::vector<Filling> found;
    for (Hole& hole : holes_of(work_)) {
      if (hole.vertices.size() > limits_.max_edges) {
        ++done_.too_large;
        continue;
      }
      Filling filling{std::move(hole)};
      filling.triangles = triangles_for(filling.hole);
      for (const Triangle& t : filling.triangles) {
        filling.area += area({work_.at(t[0]), work_.at(t[1]), work_.at(t[2])});
      }
      if (filling.triangles.empty() || !std::isfinite(filling.area)) {
        ++done_.left;
        continue;
      }
      found.push_back(std::move(filling));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Filling& a, const Filling& b) { return a.area < b.area; });
    return found;
  }

  std::vector<Triangle> triangles_for(const Hole& hole) {
    const std::uint64_t n = hole.vertices.size();
    const std::uint64_t cost = n * n * n / 6;
    if (n > kMaxBestEdges || best_work_ + cost > kMaxBestWork) return ear_filling(work_, hole);
    best_work_ += cost;
    return best_filling(work_, hole);
  }

  /// Of triangles that edges join.
  void measure_patches() {
    patches_ = DisjointSets(work_.size());
    patch_area_.assign(work_.size(), 0);
    for (std::uint32_t vertex = 0; vertex < work_.vertices(); ++vertex) {
      for (const std::uint32_t face : work_.faces_at(vertex)) {
        const Triangle& t = work_[face];
        const std::size_t i = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
        patches_.join(face, work_.faces_at(vertex, t[(i + 1) % 3]).faces[0]);
      }
    }
    for (std::uint32_t face = 0; face < work_.size(); ++face) {
      if (work_.has(face)) patch_area_[patches_.find(face)] += area(work_.facet_of(face));
    }
  }

  bool fits(const Filling& filling) {
    const double patch = patch_area_[patches_.find(filling.hole.faces.front())];
    return filling.area <= kSheetShare * patch &&
           done_.area + filling.area <= limits_.max_area_share * done_.mesh_area;
  }

  bool fill(const Filling& filling) {
    const Hole& hole = filling.hole;
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
      const std::uint32_t next = hole.vertices[(i + 1) % hole.vertices.size()];
      if (work_.faces_at(hole.vertices[i], next).count != 1) return false;
    }
    const std::uint64_t open = work_.defects().boundary_edges;
    const bool done = work_.attempt([&] {
      std::vector<std::uint32_t> added;
      for (const Triangle& t : filling.triangles) added.push_back(work_.add(t, beside(hole, t)));
      drop_lines(work_, std::move(added));
    });
    if (!done || work_.defects().boundary_edges == open) return false;
    ++done_.filled;
    done_.triangles += filling.triangles.size();
    done_.area += filling.area;
    return true;
  }

  /// A triangle at an edge that the new one takes, or else the first round the hole.
  std::uint32_t beside(const Hole& hole, const Triangle& t) const {
    for (const std::size_t i : {0U, 1U, 2U}) {
      const EdgeFaces at = work_.faces_at(t[i], t[(i + 1) % 3]);
      if (at.count > 0) return at.faces[0];
    }
    return hole.faces.front();
  }

  Workpiece& work_;
  HoleLimits limits_;
  HolesFilled done_;
  std::uint64_t best_work_ = 0;
  DisjointSets patches_{0};
  std::vector<double> patch_area_;  // at the first triangle of each
};

}  // namespace

HolesFilled fill_holes(Workpiece& work, const HoleLimits& limits) {
  return Filler(work, limits).run();
}

}  // namespace rigor::mesh
