// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/spatial/self_intersection.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <rigor/mesh/spatial/bvh.h>
#include <rigor/mesh/spatial/predicate.h>
#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

/// A triangle by its corners, as positions and as welded places.
struct Face {
  const Facet& at;
  const Triangle& place;
};

/// The corners of one triangle in an order in which those shared with another come first.
struct Match {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::size_t shared = 0;

  void share(std::size_t corner) {
    std::swap(order[shared], *std::find(order.begin(), order.end(), corner));
    ++shared;
  }
};

/// For two triangles at the edge from p to q, with the third corners a and b: whether they lie in one
/// plane, on the same side of the edge.
bool fold_over(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b) {
  if (side(p, q, a, b) != 0) return false;
  const int axis = axis_of_view({p, q, a});
  const auto side_of_edge = [&](const Vector3& corner) {
    return turn(seen_along(axis, p), seen_along(axis, q), seen_along(axis, corner));
  };
  return side_of_edge(a) == side_of_edge(b);
}

/// For two triangles that share f[0] = g[0]. What else they have in common can be followed, away from
/// that corner, to where one of them ends: at its edge across from it.
bool meet_again(const Facet& f, const Facet& g) {
  const int g1 = side(f, g[1]);
  const int g2 = side(f, g[2]);
  if (g1 * g2 > 0) return false;
  const int f1 = side(g, f[1]);
  const int f2 = side(g, f[2]);
  if (f1 * f2 > 0) return false;
  return meet(Segment{g[1], g[2]}, f) || meet(Segment{f[1], f[2]}, g);
}

bool intersect(const Face& f, const Face& g) {
  Match of_f;
  Match of_g;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (f.place[i] != g.place[j]) continue;
      of_f.share(i);
      of_g.share(j);
    }
  }
  if (of_f.shared == 0) return meet(f.at, g.at);
  if (of_f.shared == 3) return false;
  const auto corner = [](const Face& face, const Match& match, std::size_t i) {
    return face.at[match.order[i]];
  };
  if (of_f.shared == 2) {
    return fold_over(corner(f, of_f, 0), corner(f, of_f, 1), corner(f, of_f, 2),
                     corner(g, of_g, 2));
  }
  return meet_again({corner(f, of_f, 0), corner(f, of_f, 1), corner(f, of_f, 2)},
                    {corner(g, of_g, 0), corner(g, of_g, 1), corner(g, of_g, 2)});
}

/// Goes back and forth between the triangles from the middle of where their boxes overlap (alternating
/// projections: W. Cheney, A. Goldstein, 1959).
Vector3 between(const Facet& f, const Facet& g) {
  constexpr int kRounds = 64;
  const auto middle_of_overlap = [&](double Vector3::*k) {
    const double low =
        std::max(std::min({f[0].*k, f[1].*k, f[2].*k}), std::min({g[0].*k, g[1].*k, g[2].*k}));
    const double high =
        std::min(std::max({f[0].*k, f[1].*k, f[2].*k}), std::max({g[0].*k, g[1].*k, g[2].*k}));
    return low / 2 + high / 2;
  };
  Vector3 p{middle_of_overlap(&Vector3::x), middle_of_overlap(&Vector3::y),
            middle_of_overlap(&Vector3::z)};
  for (int i = 0; i < kRounds; ++i) p = closest_point(g, closest_point(f, p));
  return p;
}

/// The corners of f that g does not share, and where edges of f go through the plane of g.
std::vector<Vector3> likely_places(const Facet& f, const Facet& g) {
  std::vector<Vector3> result;
  std::copy_if(f.begin(), f.end(), std::back_inserter(result),
               [&](const Vector3& p) { return std::find(g.begin(), g.end(), p) == g.end(); });
  const Vector3 normal = cross(g[1] - g[0], g[2] - g[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& a = f[i];
    const Vector3& b = f[(i + 1) % 3];
    const double above = dot(normal, a - g[0]);
    const double below = dot(normal, b - g[0]);
    if (above * below < 0) result.push_back(a + (above / (above - below)) * (b - a));
  }
  return result;
}

/// A place in both, but for rounding: for showing only.
Vector3 common_place(const Facet& f, const Facet& g) {
  const auto off = [&](const Vector3& p) {
    return std::max(length(closest_point(f, p) - p), length(closest_point(g, p) - p));
  };
  Vector3 best = between(f, g);
  for (const auto& places : {likely_places(f, g), likely_places(g, f)}) {
    for (const Vector3& p : places) {
      if (off(p) < off(best)) best = p;
    }
  }
  return best;
}

/// The triangles that can be examined.
struct Sound {
  std::vector<Facet> facets;
  std::vector<Triangle> places;
  std::vector<std::uint32_t> indices;  ///< into the mesh's triangles
};

bool sound(const Facet& f) {
  const auto seen = [](const Vector3& p) { return within_reach(p) && exactly_seen(p); };
  return std::all_of(f.begin(), f.end(), seen) && axis_of_view(f) != 3;
}

Sound sound_triangles(const TriangleMesh& mesh) {
  const Weld welded = weld(mesh.positions);
  Sound result;
  result.facets.reserve(mesh.triangles.size());
  result.places.reserve(mesh.triangles.size());
  result.indices.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Facet f = facet(mesh, t);
    if (!sound(f)) continue;
    result.facets.push_back(f);
    result.places.push_back({welded.place[t[0]], welded.place[t[1]], welded.place[t[2]]});
    result.indices.push_back(i);
  }
  return result;
}

class Search {
 public:
  explicit Search(const TriangleMesh& mesh) : mesh_(mesh) {}

  SelfIntersections run() {
    const Sound all = sound_triangles(mesh_);
    const Bvh tree(all.facets);
    std::vector<Triangle> places(tree.size());  // of each slot
    for (std::uint32_t i = 0; i < tree.size(); ++i) places[i] = all.places[tree.index(i)];
    const std::uint64_t budget = kMaxIntersectionLooks + kMaxIntersectionLooksEach * tree.size();
    found_.complete = tree.pairs(budget, [&](std::uint32_t i, std::uint32_t j) {
      if (!intersect({tree.facet(i), places[i]}, {tree.facet(j), places[j]})) return true;
      add(all.indices[tree.index(i)], all.indices[tree.index(j)]);
      return found_.pairs < kMaxIntersectingPairs;
    });
    found_.left_out = mesh_.triangles.size() - tree.size();
    for (Intersection& example : found_.examples) place(example);
    return std::move(found_);
  }

 private:
  /// Keeps the least examples, in order, so that they don't depend on the tree.
  void add(std::uint64_t a, std::uint64_t b) {
    ++found_.pairs;
    const std::array<std::uint64_t, 2> triangles{std::min(a, b), std::max(a, b)};
    std::vector<Intersection>& kept = found_.examples;
    if (kept.size() == kMaxIntersectionExamples) {
      if (triangles > kept.back().triangles) return;
      kept.pop_back();
    }
    const auto less = [&](const Intersection& other) { return other.triangles < triangles; };
    kept.insert(std::partition_point(kept.begin(), kept.end(), less), {triangles, {}});
  }

  void place(Intersection& example) const {
    const auto at = [&](std::uint64_t t) { return facet(mesh_, mesh_.triangles[t]); };
    example.at = common_place(at(example.triangles[0]), at(example.triangles[1]));
  }

  const TriangleMesh& mesh_;
  SelfIntersections found_;
};

}  // namespace

SelfIntersections self_intersections(const TriangleMesh& mesh) { return Search(mesh).run(); }

}  // namespace rigor::mesh
