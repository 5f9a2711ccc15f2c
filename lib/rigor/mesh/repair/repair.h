// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Repairs what can be repaired of a mesh without guessing at its shape. The steps, in this order:
//
//   weld             positions of the same coordinates, or within a distance that is asked for
//   drop degenerate  triangles with two corners in one place
//   drop duplicates  copies of triangles, and walls that two bodies share
//   drop lines       triangles with three corners on a line, without opening what they hold together
//   drop fins        small patches on edges of three or more triangles, which close nothing
//   close seams      borders that differ by rounding
//   turn consistent  neighbors face the same side
//   fill holes       small ones
//   face outward     closed bodies, and what lies in them with them
//   drop specks      components that are tiny beside the whole
//
// Nothing that `Topology` counts gets worse, slivers apart: what would is left as it was. Vertices
// stay where they are, but for rounding at seams, unless a distance to weld within is asked for. What
// triangles carry (parts, texture, colors) stays theirs.
//
//   Repaired repaired = repair(std::move(mesh), {});
//   tell(repaired.report.before, repaired.report.after);

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <rigor/mesh/repair/fill_holes.h>
#include <rigor/mesh/repair/workpiece.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::mesh {

struct RepairOptions {
  double weld_distance = 0;  ///< in the mesh's unit; 0 welds what has the same coordinates only
  HoleLimits holes;
  /// Area of all fins that go, over that of the mesh. They bound no volume, but are seen: so no more
  /// than what a picture of the whole would not show.
  double fin_share = 1e-3;
  /// Components whose box has a diagonal below this share of the whole one's go; 0 keeps all. A
  /// thousandth is below what any printer or camera shows of the whole.
  double speck_share = 1e-3;
};

enum class RepairStep : std::uint8_t {
  kWeld,
  kDropDegenerate,
  kDropDuplicates,
  kDropLines,
  kDropFins,
  kCloseSeams,
  kTurnConsistent,
  kFillHoles,
  kFaceOutward,
  kDropSpecks
};

/// "weld", "drop degenerate" …, as above.
std::string_view to_string(RepairStep step);

struct StepDone {
  RepairStep step;
  std::uint64_t changed = 0;  ///< vertices, triangles, holes or components, as the step has them
  bool undone = false;        ///< the welding made something worse, so it was done without
  DefectCounts before;
  DefectCounts after;
};

struct RepairReport {
  Topology before;
  Topology after;
  std::vector<StepDone> steps;  ///< all, in their order
  HolesFilled holes;
};

struct Repaired {
  TriangleMesh mesh;
  RepairReport report;
};

Repaired repair(TriangleMesh mesh, const RepairOptions& options);

}  // namespace rigor::mesh
