// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/fins.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <rigor/mesh/topology/rings.h>

namespace rigor::mesh {
namespace {

struct Patch {
  std::vector<std::uint32_t> faces;
  double area = 0;
  bool hangs = false;  ///< on an edge of more than two
};

Patch sheet_of(const Workpiece& work, std::uint32_t first, std::vector<bool>& seen) {
  Patch patch{{first}};
  seen[first] = true;
  for (std::size_t next = 0; next < patch.faces.size(); ++next) {
    const std::uint32_t face = patch.faces[next];
    const Triangle& t = work[face];
    patch.area += area(work.facet_of(face));
    for (const auto& [i, k] : kSides) {
      const EdgeFaces at = work.faces_at(t[i], t[k]);
      patch.hangs = patch.hangs || at.count > 2;
      if (at.count != 2) continue;
      const std::uint32_t other = at.faces[0] == face ? at.faces[1] : at.faces[0];
      if (seen[other]) continue;
      seen[other] = true;
      patch.faces.push_back(other);
    }
  }
  return patch;
}

}  // namespace

std::uint64_t drop_fins(Workpiece& work, double max_area_share) {
  if (work.defects().nonmanifold_edges == 0) return 0;
  std::vector<Patch> patches;
  std::vector<bool> seen(work.size());
  double whole = 0;
  for (std::uint32_t face = 0; face < work.size(); ++face) {
    if (!work.has(face) || degenerate(work[face]) || seen[face]) continue;
    patches.push_back(sheet_of(work, face, seen));
    whole += patches.back().area;
  }
  std::erase_if(patches, [](const Patch& patch) { return !patch.hangs; });
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.area < b.area; });
  std::uint64_t dropped = 0;
  double area = 0;
  for (const Patch& patch : patches) {
    if (!(area + patch.area <= max_area_share * whole) || work.tired()) break;
    const std::uint64_t before = work.defects().nonmanifold_edges;
    if (before == 0) break;
    const bool gone = work.attempt([&] {
      for (const std::uint32_t face : patch.faces) work.remove(face);
    });
    if (!gone) continue;
    area += patch.area;
    dropped += patch.faces.size();
  }
  return dropped;
}

}  // namespace rigor::mesh
