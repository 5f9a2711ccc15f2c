// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/seams.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <rigor/mesh/topology/holes.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::mesh {
namespace {

// Vertices examined along x for each; more are in one place only in files made for it.
constexpr std::size_t kMaxNear = 64;

// Where three borders meet, two are joined first.
constexpr int kMaxSeamRounds = 4;

struct SeamSide {
  std::uint32_t vertex;
  std::uint32_t hole;
};

/// A vertex that goes to the place of another.
struct Join {
  std::uint32_t vertex;
  std::uint32_t to;
  std::uint32_t hole;
};

/// Vertices at holes, along x.
std::vector<SeamSide> borders(const Workpiece& work) {
  std::vector<SeamSide> found;
  const std::vector<Hole> holes = holes_of(work);
  for (std::uint32_t hole = 0; hole < holes.size(); ++hole) {
    for (const std::uint32_t vertex : holes[hole].vertices) found.push_back({vertex, hole});
  }
  std::erase_if(found, [&](const SeamSide& b) { return !std::isfinite(work.at(b.vertex).x); });
  std::sort(found.begin(), found.end(), [&](const SeamSide& a, const SeamSide& b) {
    return std::pair(work.at(a.vertex).x, a.vertex) < std::pair(work.at(b.vertex).x, b.vertex);
  });
  return found;
}

double reach(const Workpiece& work) {
  double greatest = 0;
  for (std::uint32_t vertex = 0; vertex < work.vertices(); ++vertex) {
    const Vector3& p = work.at(vertex);
    greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return greatest;
}

void join_borders(Workpiece& work, const Join& join) {
  const std::vector<std::uint32_t> faces = work.faces_at(join.vertex);
  for (const std::uint32_t face : faces) {
    Triangle t = work[face];
    std::replace(t.begin(), t.end(), join.vertex, join.to);
    work.remove(face);
    if (!degenerate(t)) work.add_piece(t, face);
  }
}

/// Each with the seam that it is part of: holes are parts of one when a vertex of one goes to another.
std::vector<std::vector<Join>> seams(const Workpiece& work) {
  const std::vector<SeamSide> border = borders(work);
  const double distance = kSeamDistance * reach(work);
  std::uint32_t holes = 0;
  for (const SeamSide& b : border) holes = std::max(holes, b.hole + 1);
  DisjointSets together(holes);
  std::vector<bool> gone(work.vertices());
  std::vector<Join> joins;
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (gone[border[i].vertex]) continue;
    for (std::size_t k = i + 1; k < std::min(border.size(), i + kMaxNear); ++k) {
      const auto [a, b] = std::pair(border[i].vertex, border[k].vertex);
      if (work.at(b).x - work.at(a).x > distance) break;
      if (a == b || gone[b] || length(work.at(b) - work.at(a)) > distance) continue;
      gone[b] = true;
      together.join(border[i].hole, border[k].hole);
      joins.push_back({b, a, border[i].hole});
    }
  }
  std::vector<std::vector<Join>> found(holes);
  for (const Join& j : joins) found[together.find(j.hole)].push_back(j);
  std::erase_if(found, [](const std::vector<Join>& seam) { return seam.empty(); });
  return found;
}

/// Returns how many vertices were joined.
std::uint64_t close_once(Workpiece& work) {
  std::uint64_t joined = 0;
  for (const std::vector<Join>& seam : seams(work)) {
    if (work.tired()) break;
    const bool whole = work.attempt([&] {
      for (const Join& j : seam) join_borders(work, j);
    });
    if (whole) {
      joined += seam.size();
      continue;
    }
    for (const Join& j : seam) {
      if (work.tired()) break;
      joined += work.attempt([&] { join_borders(work, j); }) ? 1 : 0;
    }
  }
  return joined;
}

}  // namespace

std::uint64_t close_seams(Workpiece& work) {
  std::uint64_t joined = 0;
  for (int round = 0; round < kMaxSeamRounds && !work.tired(); ++round) {
    const std::uint64_t now = close_once(work);
    joined += now;
    if (now == 0) break;
  }
  return joined;
}

}  // namespace rigor::mesh
