// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes that have no counterpart to be compared with: one that hangs beside the other shapes of its link,
// and the only one of a link, which is compared with the links around it and with the center of mass.
//
//   look_for_loose(link, context);
//   check_lone_shapes(context);

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/attachment.h>
#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/assembly/written_places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_origin_slip {

using model::Vector3;

/// Whether its pose is written in the frame of the link.
inline bool is_in_link(const SeenShape& one) {
  return one.pose->pose.written && one.pose->relative_to.value.empty();
}

// Shares of the longest link: how far the only shape of a link is from all other links, and of its way there.
inline constexpr double kFloating = 0.03;
inline constexpr double kTouching = 0.01;
inline constexpr double kByFactor = 0.75;
inline constexpr double kBySign = 0.3;

/// The shape of a link that has no other, when its origin is what places it.
inline std::optional<SeenShape> lone_shape(std::uint32_t link, Context& context) {
  const robot::AssembledLink& assembled = context.assembled().links[link];
  if (assembled.shapes.size() != 1 || !assembled.complete() || !assembled.carrier)
    return std::nullopt;
  const SeenShape one = seen_shapes(link, context).front();
  if (!is_in_link(one) || !context.root().own(one.geometry->site)) return std::nullopt;
  return one;
}

inline void look_at_lone(const SeenShape& one, const Attached& attached, double longest,
                         Context& context) {
  const model::Pose& now = one.pose->pose.value;
  for (const Undone& change : placement_slips(now.translation)) {
    const Vector3 moved = rotate(attached.unit.X_WL.rotation, change.value - now.translation);
    const Fit then = fit_of(attached, moved);
    constexpr double kPartly = 0.6;
    if (then.gap > kTouching * longest || then.inside > kPartly) continue;
    const bool same_length = std::abs(length(change.value) - length(now.translation)) < 1e-9;
    const bool explained = attached.fit.gap > (same_length ? kBySign : kByFactor) * length(moved);
    context.report(
        {.where = place_of(*one.pose, context),
         .message = fmt::format("the {} is the only shape of its link, and {:.3g} m away from all "
                                "other links",
                                role_name(one), attached.fit.gap),
         .subject = subject_of_shape(one, context),
         .help = fmt::format("with {} it touches them: {}", written_as(change.value), change.slip),
         .fix = translation_fix(*one.pose, change.value, context),
         .severity = explained ? std::nullopt : std::optional(Severity::kInfo)});
    return;
  }
}

// A body in more pieces is made of what touches nothing as well.
inline constexpr std::size_t kMaxInLink = 20;

// Of the shape's own size, in links whose other shapes all touch.
inline constexpr double kLoose = 0.05;

inline double gap_between(const SeenShape& one, const SeenShape& other, const Vector3& d_L) {
  const auto box = robot::moved(robot::box_around(one.shape->bounds_S, one.shape->X_LS), d_L);
  return std::max(
      0.0, robot::separation(box, robot::box_around(other.shape->bounds_S, other.shape->X_LS)));
}

inline double gap_to_others(const SeenShape& one, const std::vector<SeenShape>& all,
                            const Vector3& d_L) {
  double least = std::numeric_limits<double>::infinity();
  for (const SeenShape& other : all) {
    if (other.shape != one.shape) least = std::min(least, gap_between(one, other, d_L));
    if (least == 0) break;
  }
  return least;
}

/// A body of several shapes, of which one hangs in the air and touches the others with a slip undone.
inline bool look_for_loose(std::uint32_t link, Context& context) {
  constexpr std::size_t kFewestShapes = 3;
  const std::size_t count = context.assembled().links[link].shapes.size();
  if (count < kFewestShapes || count > kMaxInLink) return false;
  const std::vector<SeenShape> all = seen_shapes(link, context);
  const SeenShape* loose = nullptr;
  for (const SeenShape& one : all) {
    const double gap = gap_to_others(one, all, {});
    if (gap == 0) continue;
    if (loose != nullptr || gap < kLoose * mesh::diagonal(one.shape->bounds_S)) return false;
    loose = &one;
  }
  if (loose == nullptr || !is_in_link(*loose) || !context.root().own(loose->geometry->site))
    return false;
  const double gap = gap_to_others(*loose, all, {});
  const Vector3& written = loose->pose->pose.value.translation;
  std::vector<Undone> changes;
  std::optional<Undone> explained;
  for (Undone& change : placement_slips(written)) {
    if (gap_to_others(*loose, all, change.value - written) > 0) continue;
    const bool same_length = std::abs(length(change.value) - length(written)) < 1e-9;
    const double share = same_length ? kBySign : kByFactor;
    if (!explained && gap > share * length(change.value - written)) explained = change;
    changes.push_back(std::move(change));
  }
  if (changes.empty()) return false;
  const auto likely = likeliest(changes, *loose->pose, context.root());
  const bool known = is_written_elsewhere(likely->value, *loose->pose, context.root());
  const Undone& change = explained && !known ? *explained : *likely;
  // One that is not the only one, and moves it by more than it is off, is a guess.
  const bool only = explained || known || changes.size() == 1;
  context.report(
      {.where = place_of(*loose->pose, context),
       .message = fmt::format("the {} is {:.3g} m away from the link's {} other shapes, which all "
                              "touch",
                              role_name(*loose), gap, all.size() - 1),
       .subject = subject_of_shape(*loose, context),
       .help = fmt::format("with {} it touches them: {}", written_as(change.value), change.slip),
       .fix = only ? translation_fix(*loose->pose, change.value, context) : std::nullopt,
       .severity = explained ? std::nullopt : std::optional(Severity::kInfo)});
  return true;
}

// Of the shape's own size: how far its middle is from the center of mass, as written and then.
inline constexpr double kBesideMass = 0.75;
inline constexpr double kAroundMass = 0.25;

/// The only shape of a link that weighs something is about its center of mass.
inline bool look_at_mass(const SeenShape& one, std::uint32_t link, Context& context) {
  const model::Inertial& inertial = context.root().links[link].inertial;
  if (!inertial.pose.pose.written || !(inertial.mass.value > 0)) return false;
  const Vector3& com = inertial.pose.pose.value.translation;
  const Vector3 middle = 0.5 * (one.bounds_L.min + one.bounds_L.max);
  const double size = mesh::diagonal(one.shape->bounds_S);
  const double off = length(com - middle);
  const Vector3& written = one.pose->pose.value.translation;
  if (off < kBesideMass * size || com == Vector3{}) return false;
  std::vector<Undone> changes = placement_slips(written);
  if (nonzero_coordinates(written) == 0) changes.push_back({com, "it was left out"});
  for (const Undone& change : changes) {
    if (length(com - middle - (change.value - written)) > kAroundMass * size) continue;
    context.report(
        {.where = place_of(*one.pose, context),
         .message =
             fmt::format("the middle of the {}, the only shape of its link, is {:.3g} m away "
                         "from the center of mass",
                         role_name(one), off),
         .subject = subject_of_shape(one, context),
         .related = {{place_of(inertial.pose, context), "the center of mass"}},
         .help = fmt::format("with {} it is around it: {}", written_as(change.value), change.slip),
         .fix = translation_fix(*one.pose, change.value, context),
         .severity = Severity::kInfo});
    return true;
  }
  return false;
}

/// Shapes without a counterpart are compared with the links around them.
inline void check_lone_shapes(Context& context) {
  const robot::Assembled& robot = context.assembled();
  std::vector<std::uint32_t> lone;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const auto one = lone_shape(i, context);
    if (!one || look_at_mass(*one, i, context)) continue;
    if (nonzero_coordinates(one->pose->pose.value.translation) > 0) lone.push_back(i);
  }
  constexpr std::size_t kFewestLinks = 4;
  if (lone.empty() || robot.links.size() < kFewestLinks) return;
  const std::vector<Attached> all = AttachedLinks(context).find();
  const auto floating =
      std::count_if(all.begin(), all.end(), [](const Attached& one) { return one.fit.gap > 0; });
  constexpr std::ptrdiff_t kOddInTen = 10;
  if (floating > 1 + static_cast<std::ptrdiff_t>(all.size()) / kOddInTen) return;
  for (const Attached& one : all) {
    if (one.child.size() != 1 || one.fit.gap == 0) continue;
    if (std::find(lone.begin(), lone.end(), one.unit.link) == lone.end()) continue;
    double longest = 0;
    for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
      if (robot.links[i].top == robot.links[one.unit.link].top)
        longest = std::max(longest, robot.longest({i}));
    }
    if (one.fit.gap > kFloating * longest)
      look_at_lone(*lone_shape(one.unit.link, context), one, longest, context);
  }
}

}  // namespace rigor::rules::shape_origin_slip
