// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/convex/pieces.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <rigor/mesh/convex/cut_planes.h>
#include <rigor/mesh/convex/hull.h>
#include <rigor/mesh/convex/piece_join.h>
#include <rigor/mesh/convex/plane_cut.h>
#include <rigor/mesh/convex/strict_hull.h>
#include <rigor/mesh/primitive/principal_axes.h>
#include <rigor/mesh/solids.h>

namespace rigor::mesh {
namespace {

/// Pieces that are cut for one that is wanted: what was cut badly, joining puts right.
constexpr std::size_t kCutFor = 3;

/// Planes that are tried for a cut: fewer for many triangles, so that a cut takes a second or so.
constexpr std::size_t kMaxPlanes = 60;
constexpr std::size_t kMinPlanes = 12;
constexpr std::size_t kMaxTriangleCuts = 1'000'000;

/// What a plane through all concave edges may cost, as a share of the piece's hull: often no single cut
/// leaves less empty (a ring needs two), and then one along the edges prepares the next.
constexpr double kConcaveWorth = 0.05;

/// Hulls that touch without a gap are one: their common hull has no more volume but by rounding.
constexpr double kNoMore = 1e-6;

struct Piece {
  Solid solid;
  Hull hull;
  bool whole = false;  // not to be cut, or not again

  double empty() const { return whole ? 0 : hull.volume - solid.volume.value_or(hull.volume); }
};

std::optional<Piece> piece_of(Solid solid) {
  auto hull = convex_hull(solid.mesh.positions);
  if (!hull) return std::nullopt;
  const double volume = enclosed_volume(*hull);
  const bool whole = !solid.volume || solid.mesh.triangles.size() > kMaxCutTriangles;
  return Piece{std::move(solid), {std::move(*hull), volume}, whole};
}

std::vector<Piece> halved(const TriangleMesh& mesh, const Plane& plane) {
  const Halves halves = cut(mesh, plane, kOnPlane32);
  std::vector<Piece> parts;
  for (const TriangleMesh& half : {halves.below, halves.above}) {
    for (Solid& solid : solids_of(half)) {
      if (auto piece = piece_of(std::move(solid))) parts.push_back(std::move(*piece));
    }
  }
  return parts;
}

/// What the best plane makes of it.
std::vector<Piece> best_cut(const Piece& piece) {
  const TriangleMesh& mesh = piece.solid.mesh;
  const std::size_t planes =
      std::clamp(kMaxTriangleCuts / mesh.triangles.size(), kMinPlanes, kMaxPlanes);
  std::vector<Piece> best;
  double least = 0;
  for (const CutPlane& candidate : planes_to_try(mesh, planes)) {
    std::vector<Piece> parts = halved(mesh, candidate.plane);
    if (parts.size() < 2) continue;
    double cost = -kConcaveWorth * candidate.concave * piece.hull.volume;
    for (const Piece& part : parts) cost += part.hull.volume;
    if (!best.empty() && cost >= least) continue;
    least = cost;
    best = std::move(parts);
  }
  return best;
}

void cut_all(std::vector<Piece>& pieces, std::size_t count, double tolerated) {
  while (pieces.size() < count) {
    double empty = 0;
    for (const Piece& piece : pieces) empty += piece.empty();
    if (empty <= tolerated) return;
    const auto emptiest =
        std::max_element(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.empty() < b.empty(); });
    std::vector<Piece> parts = best_cut(*emptiest);
    if (parts.empty()) {
      emptiest->whole = true;
      continue;
    }
    pieces.erase(emptiest);
    std::move(parts.begin(), parts.end(), std::back_inserter(pieces));
  }
}

}  // namespace

Pieces convex_pieces(const TriangleMesh& mesh, const PieceLimits& limits) {
  Pieces result;
  std::vector<Piece> pieces;
  Solid all;  // of too many, the corners
  double volume = 0;
  std::vector<Solid> solids = solids_of(mesh);
  result.solids = solids.size();
  const bool many = solids.size() > kMaxSolids;
  for (Solid& solid : solids) {
    if (!solid.volume) {
      ++result.open;
    } else if (many || solid.mesh.triangles.size() > kMaxCutTriangles) {
      ++result.too_large;
    }
    volume += solid.volume.value_or(0);
    if (many) {
      const std::vector<Vector3>& corners = solid.mesh.positions;
      all.mesh.positions.insert(all.mesh.positions.end(), corners.begin(), corners.end());
      continue;
    }
    if (auto piece = piece_of(std::move(solid))) {
      pieces.push_back(std::move(*piece));
    } else {
      ++result.flat;
    }
  }
  if (result.open == 0) result.mesh_volume = volume;
  if (many) {
    if (auto piece = piece_of(std::move(all))) pieces.push_back(std::move(*piece));
  }
  const std::size_t count = std::clamp<std::size_t>(limits.count, 1, kMaxPieces);
  if (count > 1) cut_all(pieces, kCutFor * count, limits.tolerance * volume);

  std::vector<Hull> hulls;
  for (Piece& piece : pieces) hulls.push_back(std::move(piece.hull));
  join_hulls(hulls, count, kNoMore * volume);
  for (Hull& hull : hulls) {
    result.hulls.push_back(made_strict(std::move(hull.mesh)));
    result.hull_volume += enclosed_volume(result.hulls.back());
  }
  return result;
}

}  // namespace rigor::mesh
