// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_origin_slip {

using model::Vector3;

// How alike the boxes around what is touched and what is seen are, as written and with the slip undone:
// bodies are simplified, and a shape that is too short for its visual lies within it at several places.
constexpr double kUnlike = 0.5;
constexpr double kAlike = 0.6;
constexpr double kBetter = 0.25;

// Many shapes are a body in pieces, which one origin changes little.
constexpr std::size_t kMostShapes = 20;

/// Another pose of a shape.
struct Repose {
  model::Pose X_LS;
  std::string slip;
  bool turned = false;  ///< the rotation, not the translation
};

/// The box around all shapes of a role, with one of them elsewhere.
mesh::Bounds joined_with(const std::vector<SeenShape>& all, const SeenShape& one,
                         const mesh::Bounds& there) {
  mesh::Bounds result = there;
  for (const SeenShape& other : all) {
    if (other.shape != one.shape && other.is_collision() == one.is_collision())
      result = robot::joined(result, other.bounds_L);
  }
  return result;
}

std::optional<mesh::Bounds> bounds_of_others(const std::vector<SeenShape>& all,
                                             const SeenShape& one) {
  std::optional<mesh::Bounds> result;
  for (const SeenShape& other : all) {
    if (other.is_collision() == one.is_collision()) continue;
    result = result ? robot::joined(*result, other.bounds_L) : other.bounds_L;
  }
  return result;
}

std::vector<Repose> reposes(const SeenShape& one, const std::vector<SeenShape>& all) {
  std::vector<Repose> result;
  const model::Pose& now = one.pose->pose.value;
  for (Undone& change : placement_slips(now.translation))
    result.push_back({{change.value, now.rotation}, std::move(change.slip), false});
  for (const SeenShape& other : all) {
    if (other.is_collision() == one.is_collision() || !other.pose->pose.written) continue;
    const model::Pose& theirs = other.pose->pose.value;
    const std::string of = fmt::format("that of the {}", role_name(other));
    result.push_back({{theirs.translation, now.rotation}, of, false});
    result.push_back({{now.translation, theirs.rotation}, of, true});
  }
  return result;
}

struct Better {
  Repose repose;
  double likeness = 0;
};

std::optional<Better> best_for(const SeenShape& one, const std::vector<SeenShape>& all,
                               double now) {
  const auto others = bounds_of_others(all, one);
  if (!others) return std::nullopt;
  std::optional<Better> best;
  for (Repose& repose : reposes(one, all)) {
    const auto there = robot::bounds_of(robot::box_around(one.shape->bounds_S, repose.X_LS));
    const double then = robot::likeness(joined_with(all, one, there), *others);
    if (then < kAlike || then < now + kBetter || (best && then <= best->likeness + 0.01)) continue;
    best = Better{std::move(repose), then};
  }
  return best;
}

double likeness_of(const std::vector<SeenShape>& all) {
  const auto touched =
      std::find_if(all.begin(), all.end(), [](const SeenShape& one) { return one.is_collision(); });
  if (touched == all.end()) return 1;
  const auto seen = bounds_of_others(all, *touched);
  return seen ? robot::likeness(joined_with(all, *touched, touched->bounds_L), *seen) : 1;
}

void check_link(std::uint32_t link, Context& context) {
  const model::Root& root = context.root();
  const std::vector<SeenShape> all = seen_shapes(link, context);
  if (all.size() < 2 || all.size() > kMostShapes) return;
  const double now = likeness_of(all);
  if (now > kUnlike) return;
  const SeenShape* wrong = nullptr;
  std::optional<Better> best;
  for (const SeenShape& one : all) {
    if (!one.pose->pose.written || !root.own(one.geometry->site)) continue;
    auto found = best_for(one, all, now);
    if (!found || (best && found->likeness <= best->likeness + 0.01)) continue;
    best = std::move(found);
    wrong = &one;
  }
  if (wrong == nullptr) return;
  const model::Pose& then = best->repose.X_LS;
  const char* what = best->repose.turned ? "rotation" : "origin";
  context.report(
      {.where = place_of(*wrong->pose, context),
       .message = fmt::format("the link's collisions and visuals share {:.0f} % of the box around "
                              "them, and {:.0f} % with another {} of the {}",
                              100 * now, 100 * best->likeness, what, role_name(*wrong)),
       .subject = subject_of_shape(*wrong, context),
       .help = best->repose.turned
                   ? "write the same rotation in both: " + best->repose.slip + " fits"
                   : fmt::format("write {}: {}", written_as(then.translation), best->repose.slip),
       .fix = best->repose.turned ? std::nullopt
                                  : translation_fix(*wrong->pose, then.translation, context)});
}

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (link.collisions.empty() || link.visuals.empty() || !root.own(link.site)) continue;
    if (context.assembled().links[i].complete()) check_link(i, context);
  }
}

Rule rule() {
  return {
      .name = "shape-origin-slip",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a collision and a visual fit each other once a slip in an origin is undone",
      .why = "What is seen is not what is touched. The box around the link's collisions and that "
             "around its visuals share little, and much once a unit, a decimal point, a sign, two "
             "exchanged coordinates or a rotation in one origin is put right, or the other's "
             "origin is written.",
      .what_to_do = "Write the origin that makes them fit.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_origin_slip
