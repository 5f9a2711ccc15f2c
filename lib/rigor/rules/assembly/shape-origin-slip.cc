// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/assembly/shapes_alone.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_origin_slip {

// How alike the boxes around what is touched and what is seen are, as written and with the slip undone:
// bodies are simplified, and a shape that is too short for its visual lies within it at several places.
constexpr double kUnlike = 0.45;
constexpr double kAlike = 0.6;
constexpr double kBetter = 0.25;

// What an origin that was left out has ahead of others.
constexpr double kLeftOut = 0.05;

// Of the shape's own size: what moves it by less explains little.
constexpr double kMoved = 0.2;

// Many shapes are a body in pieces, which one origin changes little.
constexpr std::size_t kMaxShapes = 20;

/// Another pose of a shape.
struct Repose {
  model::Pose X_LS;
  std::string slip;
  bool turned = false;  ///< the rotation, not the translation
  bool copied = false;  ///< from another shape, in the place of numbers
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
    result.push_back({{change.value, now.rotation}, std::move(change.slip), false, false});
  constexpr double kQuarter = std::numbers::pi / 2;
  const std::pair<const char*, Vector3> axes[] = {
      {"x", {1, 0, 0}}, {"y", {0, 1, 0}}, {"z", {0, 0, 1}}};
  for (const auto& [name, axis] : axes) {
    result.push_back({{now.translation, now.rotation * model::from_axis_angle(axis, kQuarter)},
                      fmt::format("a quarter turn about {}", name),
                      true,
                      false});
  }
  for (const SeenShape& other : all) {
    if (other.is_collision() == one.is_collision() || !is_in_link(other)) continue;
    const model::Pose& theirs = other.pose->pose.value;
    const std::string of = fmt::format("that of the {}", role_name(other));
    const bool empty = nonzero_coordinates(now.translation) == 0;
    result.push_back({{theirs.translation, now.rotation}, of, false, !empty});
    result.push_back({{now.translation, theirs.rotation}, of, true, false});
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
  const double least = kMoved * mesh::diagonal(one.shape->bounds_S);
  for (Repose& repose : reposes(one, all)) {
    const Vector3 moved = repose.X_LS.translation - one.pose->pose.value.translation;
    if (!repose.turned && length(moved) < least) continue;
    // Meshes are drawn as they come; what is chosen to lie along them is a rod, a disk or a box.
    const bool mesh = std::holds_alternative<model::Mesh>(one.geometry->shape);
    if (repose.turned && (mesh || !one.is_collision())) continue;
    const auto there = robot::bounds_of(robot::box_around(one.shape->bounds_S, repose.X_LS));
    const bool empty = nonzero_coordinates(one.pose->pose.value.translation) == 0;
    // An origin that was left out explains more than one that is odd.
    const double then =
        robot::likeness(joined_with(all, one, there), *others) + (empty ? kLeftOut : 0);
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
  if (all.size() < 2 || all.size() > kMaxShapes) return;
  const double now = likeness_of(all);
  if (now > kUnlike) return;
  const SeenShape* wrong = nullptr;
  std::optional<Better> best;
  for (const SeenShape& one : all) {
    if (!is_in_link(one) || !root.own(one.geometry->site)) continue;
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
       .message =
           fmt::format("the link's collisions and visuals share {:.0f} % of the box around "
                       "them, and {:.0f} % with another {} of the {}",
                       100 * now, 100 * std::min(1.0, best->likeness), what, role_name(*wrong)),
       .subject = context.subject(root.links[link]),
       .help = best->repose.turned
                   ? best->repose.slip + " fits: write the rotation"
                   : fmt::format("write {}: {}", written_as(then.translation), best->repose.slip),
       .fix = best->repose.turned ? std::nullopt
                                  : translation_fix(*wrong->pose, then.translation, context),
       .severity = best->repose.copied ? std::optional(Severity::kInfo) : std::nullopt});
}

void check(const model::Root& root, Context& context) {
  if (context.frames().problems().empty()) check_lone_shapes(context);
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    const std::size_t count = link.collisions.size() + link.visuals.size();
    if (count < 2 || !root.own(link.site)) continue;
    if (look_for_loose(i, context) || link.collisions.empty() || link.visuals.empty()) continue;
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
             "origin is written (an info where its own says another place). The only shape of a "
             "link is compared with the links around it.",
      .what_to_do = "Write the origin that makes them fit.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_origin_slip
