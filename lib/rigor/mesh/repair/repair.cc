// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/repair/repair.h>

#include <algorithm>
#include <array>
#include <utility>

#include <rigor/mesh/repair/clean.h>
#include <rigor/mesh/repair/fins.h>
#include <rigor/mesh/repair/orient.h>
#include <rigor/mesh/repair/specks.h>
#include <rigor/mesh/topology/nesting.h>
#include <rigor/mesh/topology/rings.h>
#include <rigor/mesh/topology/seams.h>
#include <rigor/mesh/topology/weld.h>
#include <rigor/mesh/topology/weld_within.h>

namespace rigor::mesh {
namespace {

// Copies of triangles hide holes, and turned ones edges that fit. So the first round drops copies and
// turns triangles without looking at what comes to light, the second only turns them so, the third does
// neither; and two more protect components.
constexpr int kMaxRepairRounds = 5;

Care more_care(Care care) { return care == Care::kNothing ? Care::kAllButWinding : Care::kAll; }

bool left_worse(const Topology& before, const Topology& after) {
  return worse(counts_of(before), counts_of(after)) || after.inverted > before.inverted ||
         after.doubled > before.doubled;
}

Components nested_components(const TriangleMesh& mesh) {
  DefectTally tally;
  const Weld welded = weld(mesh.positions);
  Rings rings = look_round(mesh, welded, tally);
  Components components = components_of(mesh, welded, rings);
  nest(mesh, components);
  return components;
}

/// What edges and vertices tell of, which is all that needs to know of no other component.
struct Mended {
  TriangleMesh mesh;
  std::vector<std::uint32_t> sources;  ///< of its triangles
  std::vector<StepDone> steps;
  HolesFilled holes;
};

Mended mend_once(TriangleMesh mesh, const std::vector<bool>& keep, Care care,
                 const RepairOptions& options) {
  Mended done;
  Workpiece work(std::move(mesh));
  work.take(care);
  for (std::uint32_t face = 0; face < keep.size(); ++face) {
    if (keep[face]) work.protect(face);
  }
  const auto take = [&](RepairStep name, const auto& change) {
    StepDone step{name, 0, false, work.defects(), {}};
    step.changed = change();
    step.after = work.defects();
    done.steps.push_back(step);
  };
  take(RepairStep::kDropDegenerate, [&] { return drop_degenerate(work); });
  take(RepairStep::kDropDuplicates, [&] { return drop_duplicates(work); });
  if (care == Care::kNothing) work.take(Care::kAllButWinding);
  take(RepairStep::kDropLines, [&] { return drop_lines(work); });
  take(RepairStep::kDropFins, [&] { return drop_fins(work, options.fin_share); });
  std::uint64_t turned = 0;
  take(RepairStep::kCloseSeams, [&] {
    turned = turn_consistent(work);  // borders are walked along one side
    return close_seams(work);
  });
  work.take(Care::kAll);
  take(RepairStep::kTurnConsistent, [&] { return turned + turn_consistent(work); });
  take(RepairStep::kFillHoles, [&] {
    done.holes = fill_holes(work, options.holes);
    drop_lines(work);  // at what was a border
    return done.holes.filled;
  });
  done.sources = work.sources();
  done.mesh = std::move(work).finished();
  return done;
}

/// Mends a mesh so that no more closed components lie in others that face the same way than before.
/// Such can come to light when a component closes; then it, and what it lies in, stays as it was if it
/// was open.
class CarefulMending {
 public:
  CarefulMending(const TriangleMesh& mesh, const RepairOptions& options)
      : mesh_(mesh),
        options_(options),
        speck_(options.speck_share * diagonal(bounds_of(mesh.positions))),
        before_(nested_components(mesh)),
        keep_(mesh.triangles.size()) {}

  Mended run() {
    for (int round = 0; round < kMaxRepairRounds; ++round) {
      Mended mended = mend_once(mesh_, keep_, care_, options_);
      if (worse(mended.steps.front().before, mended.steps.back().after)) {
        care_ = more_care(care_);
        continue;
      }
      const Components after = nested_components(mended.mesh);
      if (doubled(after) <= doubled(before_)) return mended;
      protect(after, mended.sources);
    }
    protect_if([](const Component& c) { return !c.closed; });
    return mend_once(mesh_, keep_, Care::kAll, options_);
  }

 private:
  /// Specks aside, since they go.
  bool doubled(const Component& c) const {
    return c.nesting == Nesting::kDoubled && diagonal(c.bounds) >= speck_;
  }

  std::uint64_t doubled(const Components& components) const {
    return static_cast<std::uint64_t>(
        std::count_if(components.list.begin(), components.list.end(),
                      [this](const Component& c) { return doubled(c); }));
  }

  void protect(const Components& after, const std::vector<std::uint32_t>& sources) {
    std::vector<bool> involved(after.list.size());
    for (std::size_t i = 0; i < after.list.size(); ++i) {
      if (!doubled(after.list[i])) continue;
      involved[i] = true;
      involved[*after.list[i].inside] = true;
    }
    std::vector<bool> touched(before_.list.size());
    for (std::size_t face = 0; face < after.of_face.size(); ++face) {
      const std::uint32_t now = after.of_face[face];
      const std::uint32_t then = before_.of_face[sources[face]];
      if (now != kNoComponent && then != kNoComponent && involved[now]) touched[then] = true;
    }
    protect_if([&](const Component& c) {
      return !c.closed && touched[static_cast<std::size_t>(&c - before_.list.data())];
    });
  }

  template <class Which>
  void protect_if(const Which& which) {
    for (std::size_t face = 0; face < keep_.size(); ++face) {
      const std::uint32_t component = before_.of_face[face];
      if (component != kNoComponent && which(before_.list[component])) keep_[face] = true;
    }
  }

  const TriangleMesh& mesh_;
  const RepairOptions& options_;
  double speck_;  // diagonals of less are specks
  Components before_;
  std::vector<bool> keep_;
  Care care_ = Care::kNothing;
};

Repaired repair_welded(TriangleMesh mesh, const RepairOptions& options) {
  Mended mended = CarefulMending(mesh, options).run();
  mesh = std::move(mended.mesh);
  Repaired done;
  done.report.holes = mended.holes;
  done.report.steps = std::move(mended.steps);
  const auto take = [&](RepairStep name, const auto& change) {
    StepDone step{name, 0, false, done.report.steps.back().after, {}};
    step.changed = change();
    step.after = step.changed > 0 ? counts_of(topology_of(mesh)) : step.before;
    done.report.steps.push_back(step);
  };
  take(RepairStep::kFaceOutward, [&] { return face_outward(mesh); });
  take(RepairStep::kDropSpecks, [&] { return drop_specks(mesh, options.speck_share); });
  done.report.after = topology_of(mesh);
  done.mesh = std::move(mesh);
  return done;
}

}  // namespace

std::string_view to_string(RepairStep step) {
  constexpr std::array<std::string_view, 10> kNames = {
      "weld",        "drop degenerate", "drop duplicates", "drop lines",   "drop fins",
      "close seams", "turn consistent", "fill holes",      "face outward", "drop specks"};
  return kNames[static_cast<std::size_t>(step)];
}

Repaired repair(TriangleMesh mesh, const RepairOptions& options) {
  const Topology before = topology_of(mesh);
  StepDone weld{RepairStep::kWeld, 0, false, counts_of(before), counts_of(before)};
  Repaired done;
  bool better = false;
  if (options.weld_distance > 0) {
    TriangleMesh near = mesh;
    weld.changed = weld_within(near, options.weld_distance);
    weld.after = counts_of(topology_of(near));
    done = repair_welded(std::move(near), options);
    better = !left_worse(before, done.report.after);
    weld.undone = !better;
  }
  if (!better) done = repair_welded(std::move(mesh), options);
  done.report.before = before;
  done.report.steps.insert(done.report.steps.begin(), weld);
  return done;
}

}  // namespace rigor::mesh
