// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/core.h>

#include <rigor/rules/inertia/outline.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/kinematics/motion.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertial_origin_missing {

constexpr double kMin = 1e-3;        // kg; less is a token for a frame that had to have some mass
constexpr double kNear = 0.02;       // of the length: what lies so near to an end is at it
constexpr double kElsewhere = 1.5;   // lengths
constexpr double kSameMiddle = 0.1;  // of the length: visuals and collisions were moved together

/// How far the middle of the shapes is from the link's origin along the axis at whose end that is.
struct Middle {
  model::Vector3 center;
  double length = 0;  ///< m, along that axis
};

/// Nothing when the origin is inside the shapes, or beside them by more than their length: then they are elsewhere.
std::optional<Middle> middle_beside_origin(const Outline& outline) {
  constexpr std::array<model::Vector3, 3> kAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Middle middle;
  for (const model::Vector3& axis : kAxes) {
    const double ahead = outline.reach(axis), behind = outline.reach(-1 * axis);
    const double length = ahead + behind;
    middle.center = middle.center + 0.5 * (ahead - behind) * axis;
    if (std::min(ahead, behind) < kNear * length) middle.length = std::max(middle.length, length);
  }
  if (middle.length == 0 || model::length(middle.center) > kElsewhere * middle.length)
    return std::nullopt;
  return middle;
}

/// Whether a joint turns or slides it: only then does its weight work against something.
bool is_carried_by_joint(const model::Link& link, Context& context) {
  const model::Root& root = context.root();
  const auto& joints = root[link.model].joints;
  return std::any_of(joints.begin(), joints.end(), [&](model::Id<model::Joint> id) {
    const auto child = context.frames().ends(id).child;
    return child && &root[child] == &link && has_axis(root[id].type);
  });
}

void check_link(const model::Link& link, LazyGroups& /*groups*/, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.written || inertial.pose.pose.written || mass::is_automatic(link)) return;
  if (!inertial.mass.written || !(inertial.mass.value > kMin) || !is_dynamic(link, context)) return;
  Outline visuals(link, context), collisions(link, context);
  if (!visuals.add_visuals(link) || visuals.empty()) return;
  if (!collisions.add_collisions(link) || collisions.empty()) return;
  const auto seen = middle_beside_origin(visuals), touched = middle_beside_origin(collisions);
  if (!seen || !touched) return;
  if (model::length(seen->center - touched->center) > kSameMiddle * touched->length) return;
  const model::Vector3& c = touched->center;
  context.report(
      {.where = inertial.site.name,
       .message = fmt::format("the center of mass is at the link's origin, an end of its shapes; "
                              "their middle is {:.4g} {:.4g} {:.4g}",
                              c.x, c.y, c.z),
       .subject = context.subject(link),
       .cause = "origin",  // who leaves it out does so of all links
       .severity = is_carried_by_joint(link, context) ? Severity::kWarning : Severity::kInfo});
}

Rule rule() {
  return {
      .name = "inertial-origin-missing",
      .severity = Severity::kInfo,
      .summary = "an inertial says nothing of its center of mass, and the shapes are beside the "
                 "link's origin",
      .why =
          "Without <origin> (in SDF <pose>) the center of mass is at the link's origin, which is "
          "its joint: visuals and collisions were moved from there, and the mass was left. The "
          "link then hangs on its joint without weight to lift. Where a joint turns or slides "
          "it, it is a warning.",
      .what_to_do =
          "Give the inertial the origin of the shapes; `rigor inertia MODEL --write` does.",
      .checks = {on<model::Root>(check_own_links<check_link>)},
  };
}

}  // namespace rigor::rules::inertial_origin_missing
