// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::center_of_mass_mirrored {

using model::Vector3;

// From the middle of the link's shapes, as a share of their size: motors are at one end of a link, and
// hardly outside of the half that they are in.
constexpr double kOff = 0.25;
constexpr double kNear = 0.1;
constexpr double kSharply = 0.4;

// Of the way to the next joint, along it.
constexpr double kBehind = 0.3;
constexpr double kAhead = 0.9;
constexpr double kStraight = 0.9;  // cosine

// m: less is a rounded number, or a sensor.
constexpr double kMin = 0.01;

struct Mirrored {
  Vector3 value;
  std::size_t coordinate = 0;
  std::string evidence;
  bool sharp = false;
};

Vector3 flipped(Vector3 p, std::size_t k) {
  p.*kCoordinates[k] = -1 * p.*kCoordinates[k];
  return p;
}

std::optional<Mirrored> beside_shapes(std::uint32_t link, const Vector3& com, Context& context) {
  const robot::Assembled& robot = context.assembled();
  if (!robot.links[link].complete()) return std::nullopt;
  auto box = robot.bounds(link, robot::ShapeRole::kCollision);
  const auto seen = robot.bounds(link, robot::ShapeRole::kVisual);
  if (box && seen) box = robot::joined(*box, *seen);
  if (!box) box = seen;
  if (!box) return std::nullopt;
  const double size = mesh::diagonal(*box);
  const Vector3 middle = 0.5 * (box->min + box->max);
  const double now = length(com - middle);
  if (!(now > kOff * size)) return std::nullopt;
  std::optional<Mirrored> best;
  double least = kNear * size;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 value = flipped(com, k);
    const double then = length(value - middle);
    if (std::abs(com.*kCoordinates[k]) < kMin || then > least) continue;
    least = then;
    best = Mirrored{value, k,
                    fmt::format("{:.3g} m away from the middle of the link's shapes, and {:.3g} m "
                                "with the other sign",
                                now, then),
                    now > kSharply * size};
  }
  return best;
}

/// Where the only joint that the link carries on is: a limb goes from its own joint to the next.
std::optional<Vector3> next_joint(std::uint32_t link, Context& context) {
  const robot::AssembledLink& assembled = context.assembled().links[link];
  if (!assembled.X_WL || assembled.links_carried.size() != 1 || !assembled.carrier)
    return std::nullopt;
  const auto& X_WC = context.assembled().links[assembled.links_carried.front()].X_WL;
  if (!X_WC) return std::nullopt;
  return transform(inverse(*assembled.X_WL), X_WC->translation);
}

std::optional<Mirrored> behind_joint(std::uint32_t link, const Vector3& com, Context& context) {
  const robot::AssembledLink& assembled = context.assembled().links[link];
  if (assembled.complete() && !assembled.shapes.empty()) return std::nullopt;  // those say it
  const auto next = next_joint(link, context);
  if (!next) return std::nullopt;
  const double reach = length(*next);
  if (!(reach > 0)) return std::nullopt;
  const double along = dot(com, *next) / reach;
  if (along > -kBehind * reach) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 value = flipped(com, k);
    const double then = dot(value, *next) / reach;
    if (then < kBehind * reach || then > kAhead * reach || then < kStraight * length(value))
      continue;
    return Mirrored{value, k,
                    fmt::format("{:.3g} m behind the link's joint, and with the other sign on the "
                                "way to the next",
                                -along),
                    false};
  }
  return std::nullopt;
}

void check(const model::Root& root, Context& context) {
  if (!context.frames().problems().empty()) return;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    const model::PoseField& pose = link.inertial.pose;
    if (!root.own(link.site) || !pose.pose.written || !(link.inertial.mass.value > 0)) continue;
    const Vector3& com = pose.pose.value.translation;
    if (length(com) < kMin) continue;
    auto found = beside_shapes(i, com, context);
    if (!found) found = behind_joint(i, com, context);
    if (!found) continue;
    context.report(
        {.where = place_of(pose, context),
         .message = fmt::format("the center of mass ({}) is {}", written_as(com), found->evidence),
         .subject = context.subject(link),
         .help = fmt::format("write {}: the sign of {} was lost", written_as(found->value),
                             coordinate_name(found->coordinate)),
         .fix = translation_fix(pose, found->value, context),
         .severity = found->sharp ? std::nullopt : std::optional(Severity::kInfo)});
  }
}

Rule rule() {
  return {
      .name = "center-of-mass-mirrored",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link's center of mass is on the wrong side, by a sign",
      .why = "The link swings and falls to the side where it is not. Its center of mass is at one "
             "end of its shapes, or beyond, and in their middle once the sign of a coordinate is "
             "changed; or behind the joint that it turns about, while the link goes the other way "
             "to the next joint. Where it is less sharp it is an info: motors are at the ends of "
             "links.",
      .what_to_do =
          "Change the sign. `rigor inertia MODEL` shows the center of mass of the shapes.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::center_of_mass_mirrored
