// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/assembly/written_places.h>
#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::center_of_mass_outside_shapes {

// What is drawn may be less than what was weighed: not all screws and cables are.
constexpr double kShare = 0.05;     // of the size
constexpr double kThin = 1e-3;      // m
constexpr double kMirrored = 0.25;  // of the size; nearer, either side may be meant
constexpr double kMin = 1e-3;       // kg; less is a token for a frame that had to have some mass

// Along the link's axes, and across the corners between them.
constexpr std::array<model::Vector3, 13> kDirections{{{1, 0, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {1, 1, 0},
                                                      {1, -1, 0},
                                                      {1, 0, 1},
                                                      {1, 0, -1},
                                                      {0, 1, 1},
                                                      {0, 1, -1},
                                                      {1, 1, 1},
                                                      {1, 1, -1},
                                                      {1, -1, 1},
                                                      {-1, 1, 1}}};

struct Outside {
  double distance = 0;  ///< m, how far outside at least
  double size = 0;      ///< m, the largest extent along an axis
};

Outside outside(const model::Vector3& com, const Outline& outline) {
  Outside result;
  for (const model::Vector3& direction : kDirections) {
    const model::Vector3 d = (1 / model::length(direction)) * direction;
    const double ahead = outline.reach(d);
    const double behind = outline.reach(-1 * d);
    const double along = model::dot(d, com);
    result.distance = std::max({result.distance, along - ahead, -along - behind});
    if (model::length(direction) == 1) result.size = std::max(result.size, ahead + behind);
  }
  return result;
}

// Farther than the link is long, and than any hand's breadth: the link then moves as another robot's would.
constexpr double kGrave = 0.1;  // m

/// The slip in the numbers without which the center of mass is within the shapes: a sign, or from far off
/// a decimal point or a unit, as nearer to the origin any point is inside.
std::optional<Undone> slip_of(const model::Vector3& com, const Outside& out,
                              const Outline& outline) {
  const bool far = out.distance > out.size;
  for (Undone& change : undone_slips(com)) {
    const bool sign = model::length(change.value) == model::length(com);
    if (!sign && !far) continue;
    if (!(outside(change.value, outline).distance > 0)) return std::move(change);
  }
  return std::nullopt;
}

/// The collisions alone, where a visual is unknown: only for what lies beside them farther than they are long,
/// and in them with one slip undone.
std::optional<Outline> collisions_with_slip(const model::Link& link, Context& context) {
  const model::Vector3& com = link.inertial.pose.pose.value.translation;
  Outline collisions(link, context);
  if (!collisions.add_collisions(link) || collisions.empty()) return std::nullopt;
  const Outside out = outside(com, collisions);
  if (out.distance <= out.size || !slip_of(com, out, collisions)) return std::nullopt;
  const bool visuals_known = Outline(link, context).add_visuals(link);
  if (visuals_known) return std::nullopt;
  return collisions;
}

void check_link(const model::Link& link, LazyGroups& groups, Context& context) {
  const model::Inertial& inertial = link.inertial;
  const model::Vector3& com = inertial.pose.pose.value.translation;
  if (!inertial.pose.pose.written || com == model::Vector3{} || mass::is_automatic(link)) return;
  if (!inertial.mass.written || !inertial.tensor_written) return;  // reported elsewhere
  if (!(inertial.mass.value > kMin) || !is_dynamic(link, context)) return;
  const auto breaks = [&com](const Outline& outline) {
    const Outside out = outside(com, outline);
    return out.distance > kShare * out.size + kThin;
  };
  const auto whole = outline_that_breaks(link, groups, context, breaks);
  const auto part = whole ? std::nullopt : collisions_with_slip(link, context);
  if (!whole && !part) return;
  const Outline& outline = whole ? *whole : *part;
  const Outside out = outside(com, outline);
  const auto slip =
      out.distance > kMirrored * out.size ? slip_of(com, out, outline) : std::optional<Undone>();
  const bool grave = slip || out.distance > std::max(kGrave, out.size);
  context.report(
      {.where = inertial.pose.site.name,
       .message = fmt::format("the center of mass ({:.4g} {:.4g} {:.4g}) is {:.3g} m outside the "
                              "link's shapes, which are {:.3g} m long",
                              com.x, com.y, com.z, out.distance, out.size),
       .subject = context.subject(link),
       .help = slip ? fmt::format("with {} it is inside: {}", written_as(slip->value), slip->slip)
                    : "it is given in the link's own frame, from the link's origin, in meters",
       // Where a shape or a joint has the same numbers, it may not be the center of mass that is wrong.
       .fix = slip && !is_written_elsewhere(com, inertial.pose, context.root(), Signs::kSame)
                  ? translation_fix(inertial.pose, slip->value, context)
                  : std::nullopt,
       .severity = grave ? Severity::kWarning : Severity::kInfo});
}

Rule rule() {
  return {
      .name = "center-of-mass-outside-shapes",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a link's center of mass is outside all of its shapes",
      .why = "The simulated body swings about a point in the air, and falls over where the real "
             "one does not. No body has its center of mass outside its convex hull. Mostly it was "
             "written in the frame of the model, of the mesh or of the joint, or for the link on "
             "the other side. It is a warning when the distance exceeds the size of the link, or "
             "when the point fits once a sign, a decimal point or a unit is put right.",
      .what_to_do = "Give it in the link's frame. Suppress the finding where the shapes are "
                    "simpler than the body. `rigor inertia MODEL` shows the center of mass of the "
                    "shapes.",
      .checks = {on<model::Root>(check_own_links<check_link>)},
  };
}

}  // namespace rigor::rules::center_of_mass_outside_shapes
