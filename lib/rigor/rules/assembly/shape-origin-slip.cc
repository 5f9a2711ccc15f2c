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

/// Whether a finding was reported.
bool check_link(std::uint32_t link, Context& context) {
  const model::Root& root = context.root();
  const std::vector<SeenShape> all = seen_shapes(link, context);
  if (all.size() < 2 || all.size() > kMaxShapes) return false;
  const double now = likeness_of(all);
  if (now > kUnlike) return false;
  const SeenShape* wrong = nullptr;
  std::optional<Better> best;
  for (const SeenShape& one : all) {
    if (!is_in_link(one) || !root.own(one.geometry->site)) continue;
    auto found = best_for(one, all, now);
    if (!found || (best && found->likeness <= best->likeness + 0.01)) continue;
    best = std::move(found);
    wrong = &one;
  }
  if (wrong == nullptr) return false;
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
  return true;
}

/// Where a collision and a visual that are as long along an axis begin and end together, once a coordinate of one
/// origin is that of the other.
struct Shifted {
  std::size_t coordinate = 0;
  double apart = 0;  ///< m
  double length = 0;
};

std::optional<Shifted> shifted(const SeenShape& touched, const SeenShape& seen) {
  // Of their length along the axis: how far their ends may be from each other, and how far they are now.
  constexpr double kTogether = 0.02;
  constexpr double kApart = 0.1;
  constexpr double kLeast = 0.005;  // m
  const Vector3 d = touched.pose->pose.value.translation - seen.pose->pose.value.translation;
  std::optional<Shifted> found;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = kCoordinates[k];
    const double low = touched.bounds_L.min.*at - seen.bounds_L.min.*at;
    const double high = touched.bounds_L.max.*at - seen.bounds_L.max.*at;
    const double length = seen.bounds_L.max.*at - seen.bounds_L.min.*at;
    const double apart = std::min(std::abs(low), std::abs(high));
    if (apart < std::max(kLeast, kApart * length)) continue;
    const double left = std::max(std::abs(low - d.*at), std::abs(high - d.*at));
    if (found || left > kTogether * length) return std::nullopt;
    found = Shifted{k, apart, length};
  }
  return found;
}

/// A cylinder or box that lies half its length off its visual, as one whose origin was left out does: the coordinate
/// that puts it there.
std::optional<Shifted> half_off(const SeenShape& touched, const SeenShape& seen) {
  // Of their length along the axis.
  constexpr double kTogether = 0.1;
  constexpr double kHalf = 0.05;
  std::optional<Shifted> found;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = kCoordinates[k];
    const double low = touched.bounds_L.min.*at - seen.bounds_L.min.*at;
    const double high = touched.bounds_L.max.*at - seen.bounds_L.max.*at;
    const double length = touched.bounds_L.max.*at - touched.bounds_L.min.*at;
    const double shift = (low + high) / 2;
    if (std::abs(shift) < kTogether * length) {
      if (std::abs(high - low) > kTogether * length) return std::nullopt;
      continue;
    }
    const bool half = std::abs(std::abs(shift) - length / 2) < kHalf * length;
    const bool left_out = touched.pose->pose.value.translation.*at == 0;
    if (found || !half || !left_out || std::abs(high - low) > kTogether * length)
      return std::nullopt;
    found = Shifted{k, std::abs(shift), length};
  }
  return found;
}

/// Of two shapes that differ in one coordinate the one where it was left out; else the one that is farther from the
/// center of mass along it. Null where neither tells.
const SeenShape* shifted_one(const SeenShape& a, const SeenShape& b, std::size_t k,
                             const model::Link& link) {
  const auto at = kCoordinates[k];
  const double p = a.pose->pose.value.translation.*at, q = b.pose->pose.value.translation.*at;
  if (p == 0 || q == 0) return p == 0 ? &a : &b;
  if (!link.inertial.pose.pose.written) return nullptr;
  const double com = link.inertial.pose.pose.value.translation.*at;
  const auto off = [&](const SeenShape& one) {
    return std::abs(0.5 * (one.bounds_L.min.*at + one.bounds_L.max.*at) - com);
  };
  constexpr double kClear = 2;
  if (off(a) > kClear * off(b)) return &a;
  return off(b) > kClear * off(a) ? &b : nullptr;
}

/// One collision and one visual of a link, which one coordinate keeps apart.
void look_for_shifted(std::uint32_t i, Context& context) {
  const std::vector<SeenShape> all = seen_shapes(i, context);
  if (all.size() != 2 || all[0].is_collision() == all[1].is_collision()) return;
  if (!all[0].pose->relative_to.value.empty() || !all[1].pose->relative_to.value.empty()) return;
  const SeenShape& touched = all[0].is_collision() ? all[0] : all[1];
  const SeenShape& seen = all[0].is_collision() ? all[1] : all[0];
  // Of one shape written twice another rule speaks.
  if (touched.geometry->shape.index() == seen.geometry->shape.index()) return;
  if (const auto off = half_off(touched, seen)) {
    context.report(
        {.where = touched.pose->pose.written ? place_of(*touched.pose, context)
                                             : touched.geometry->site.name,
         .message = fmt::format("the collision is {:.3g} m away from the visual along {}, half of "
                                "its own length",
                                off->apart, coordinate_name(off->coordinate)),
         .subject = context.subject(context.root().links[i]),
         .help = "its origin is its middle: was it left out?",
         .severity = Severity::kInfo});
    return;
  }
  const auto found = shifted(touched, seen);
  if (!found) return;
  const model::Link& link = context.root().links[i];
  const SeenShape* wrong = shifted_one(touched, seen, found->coordinate, link);
  const SeenShape& at = wrong ? *wrong : touched;
  const SeenShape& other = &at == &touched ? seen : touched;
  Vector3 value = at.pose->pose.value.translation;
  value.*kCoordinates[found->coordinate] =
      other.pose->pose.value.translation.*kCoordinates[found->coordinate];
  context.report(
      {.where = at.pose->pose.written ? place_of(*at.pose, context) : at.geometry->site.name,
       .message = fmt::format("the collision and the visual are both {:.3g} m long along {} and "
                              "{:.3g} m apart",
                              found->length, coordinate_name(found->coordinate), found->apart),
       .subject = context.subject(link),
       .help = fmt::format("with {}, the {} of the {}, they begin and end together",
                           written_as(value), coordinate_name(found->coordinate), role_name(other)),
       .fix = wrong && at.pose->pose.written ? translation_fix(*at.pose, value, context)
                                             : std::nullopt,
       .severity = Severity::kInfo});
}

void check(const model::Root& root, Context& context) {
  if (context.frames().problems().empty()) check_lone_shapes(context);
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    const std::size_t count = link.collisions.size() + link.visuals.size();
    if (count < 2 || !root.own(link.site)) continue;
    if (look_for_loose(i, context) || link.collisions.empty() || link.visuals.empty()) continue;
    if (!context.assembled().links[i].complete()) continue;
    if (!check_link(i, context)) look_for_shifted(i, context);
  }
}

Rule rule() {
  return {
      .name = "shape-origin-slip",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a collision and a visual fit each other once a slip in an origin is undone",
      .why =
          "What is seen is not what is touched. The box around the link's collisions and that "
          "around its visuals share little, and much once a unit, a decimal point, a sign, two "
          "exchanged coordinates or a rotation in one origin is put right, or the other's "
          "origin is written (an info where its own says another place). Two that are as long as "
          "each other along an axis, and begin and end together with the other's coordinate, "
          "are an info. The only shape of a link is compared with the links around it.",
      .what_to_do = "Write the origin that makes them fit.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_origin_slip
