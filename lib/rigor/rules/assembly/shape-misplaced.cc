// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_misplaced {

using model::Vector3;

// Of the shape's own diameter: bodies are simplified, and some of their parts are not modeled.
constexpr double kApart = 0.5;
// And of the longest shape beside it.
constexpr double kApartOfOthers = 0.25;
constexpr double kTouching = 0.01;

// Two shapes are of one size when their boxes are this much alike, and in one place likewise.
constexpr double kSameSize = 0.9;
constexpr double kElsewhere = 0.5;

/// To the nearest other shape, m; stops at one that is nearer than `enough`.
double gap_to(const SeenShape& one, const Vector3& d_L, const std::vector<SeenShape>& all,
              double enough) {
  const auto box = robot::moved(robot::box_around(one.shape->bounds_S, one.shape->X_LS), d_L);
  double least = std::numeric_limits<double>::infinity();
  for (const SeenShape& other : all) {
    if (other.shape == one.shape) continue;
    const auto beside = robot::box_around(other.shape->bounds_S, other.shape->X_LS);
    least = std::min(least, std::max(0.0, robot::separation(box, beside)));
    if (least <= enough) return least;
  }
  return least;
}

double longest_beside(const SeenShape& one, const std::vector<SeenShape>& all) {
  double most = 0;
  for (const SeenShape& other : all) {
    if (other.shape != one.shape) most = std::max(most, mesh::diagonal(other.shape->bounds_S));
  }
  return most;
}

Vector3 middle_of(const robot::AssembledShape& shape) {
  return transform(shape.X_LS, 0.5 * (shape.bounds_S.min + shape.bounds_S.max));
}

/// Of the largest ball around its middle that is in its box, m.
double inradius(const robot::AssembledShape& shape) {
  const Vector3 sides = shape.bounds_S.max - shape.bounds_S.min;
  return 0.5 * std::min({sides.x, sides.y, sides.z});
}

struct Elsewhere {
  const SeenShape* shape = nullptr;
  std::string message;
  std::string help;
  Vector3 value;  ///< m, that brings it to the others
  const SeenShape* beside = nullptr;
  bool decided = true;  ///< whether it is known that not the other shape is misplaced
};

bool is_in_frame_of_link(const SeenShape& one) { return one.pose->relative_to.value.empty(); }

bool is_apart(const SeenShape& one, const std::vector<SeenShape>& all) {
  const double size = mesh::diagonal(one.shape->bounds_S);
  constexpr double kToken = 0.03;  // m: a mark, not a body
  if (size < kToken) return false;
  const double limit = std::max(kApart * size, kApartOfOthers * longest_beside(one, all));
  // Most are decided by the balls inside of the boxes.
  for (const SeenShape& other : all) {
    if (other.shape == one.shape) continue;
    const double centers = length(middle_of(*other.shape) - middle_of(*one.shape));
    if (centers - inradius(*other.shape) - inradius(*one.shape) <= limit) return false;
  }
  return gap_to(one, {}, all, limit) > limit;
}

/// Of two shapes alone, a collision and a visual, one covers the other when it is there.
bool covers_alone(const SeenShape& one, const Vector3& d_L, const std::vector<SeenShape>& all) {
  if (all.size() != 2 || all[0].is_collision() == all[1].is_collision()) return true;
  const SeenShape& other = all[0].shape == one.shape ? all[1] : all[0];
  const mesh::Bounds there =
      robot::bounds_of(robot::moved(robot::box_around(one.shape->bounds_S, one.shape->X_LS), d_L));
  return robot::cover(there, other.bounds_L) > kElsewhere;
}

/// Of a shape away from all others of the link: that it is with them when a slip is undone.
std::optional<Elsewhere> apart(const SeenShape& one, const std::vector<SeenShape>& all) {
  if (!one.pose->pose.written) return std::nullopt;
  const double size = mesh::diagonal(one.shape->bounds_S);
  const double gap = gap_to(one, {}, all, 0);
  const Vector3& written = one.pose->pose.value.translation;
  for (const Undone& change : undone_slips(written)) {
    const Vector3 shift = change.value - written;
    if (gap_to(one, shift, all, kTouching * size) > kTouching * size ||
        !covers_alone(one, shift, all))
      continue;
    return Elsewhere{
        &one,
        fmt::format("the {} is {:.3g} m away from all other shapes of its link", role_name(one),
                    gap),
        fmt::format("with {} it touches them: {}", written_as(change.value), change.slip),
        change.value, nullptr};
  }
  return std::nullopt;
}

Vector3 middle_in_link(const SeenShape& one) { return 0.5 * (one.bounds_L.min + one.bounds_L.max); }

/// Of two shapes that are apart the one that is farther from the center of mass; null where that tells nothing.
const SeenShape* off_mass(const std::vector<SeenShape>& two, const model::Link& link) {
  if (!link.inertial.pose.pose.written) return nullptr;
  const Vector3& com = link.inertial.pose.pose.value.translation;
  const double first = length(com - middle_in_link(two[0]));
  const double second = length(com - middle_in_link(two[1]));
  constexpr double kClear = 2;
  if (first > kClear * second) return &two[0];
  return second > kClear * first ? &two[1] : nullptr;
}

/// Of a collision and a visual that are apart: that the one which is not about the center of mass lies on the
/// other with the origin of that, as a decimal point or a sign explains.
std::optional<Elsewhere> apart_from_mass(const SeenShape& wrong, const SeenShape& right) {
  if (!wrong.pose->pose.written || !is_in_frame_of_link(wrong) || !is_in_frame_of_link(right))
    return std::nullopt;
  const Vector3& to = right.pose->pose.value.translation;
  for (const Undone& change : placement_slips(wrong.pose->pose.value.translation)) {
    if (length(change.value - to) > kTouching * length(to)) continue;
    return Elsewhere{
        &wrong,
        fmt::format("the {} is {:.3g} m away from the {}, which is about the center of mass",
                    role_name(wrong), length(middle_in_link(wrong) - middle_in_link(right)),
                    role_name(right)),
        fmt::format("with {} it is in one place with it: {}", written_as(to), change.slip), to,
        &right};
  }
  return std::nullopt;
}

/// A collision and the visual of the same size, when there is one of each.
std::optional<Elsewhere> beside_its_like(const std::vector<SeenShape>& all,
                                         const model::Link& link) {
  if (all.size() != 2 || all[0].is_collision() == all[1].is_collision()) return std::nullopt;
  const SeenShape& touched = all[0].is_collision() ? all[0] : all[1];
  const SeenShape& seen = all[0].is_collision() ? all[1] : all[0];
  if (size_likeness(touched.bounds_L, seen.bounds_L) < kSameSize) return std::nullopt;
  if (robot::likeness(touched.bounds_L, seen.bounds_L) > kElsewhere) return std::nullopt;
  const Vector3 from = touched.pose->pose.value.translation;
  const Vector3 to = seen.pose->pose.value.translation;
  if (robot::likeness(moved_by(touched.bounds_L, to - from), seen.bounds_L) < kSameSize)
    return std::nullopt;
  // The mass tells which of the two is where the body is.
  const Vector3& com = link.inertial.pose.pose.value.translation;
  const auto middle = [](const mesh::Bounds& box) { return 0.5 * (box.min + box.max); };
  const bool collision_fits =
      link.inertial.pose.pose.written &&
      length(com - middle(touched.bounds_L)) < 0.5 * length(com - middle(seen.bounds_L));
  const bool visual_fits =
      link.inertial.pose.pose.written &&
      length(com - middle(seen.bounds_L)) < 0.5 * length(com - middle(touched.bounds_L));
  const SeenShape& wrong = collision_fits ? seen : touched;
  const Vector3 value = collision_fits ? from : to;
  // Else it is known where one of the origins was left out.
  const bool decided = collision_fits || visual_fits || from == Vector3{};
  return Elsewhere{&wrong,
                   fmt::format("the collision is {:.3g} m away from the visual of the same size",
                               length(middle(touched.bounds_L) - middle(seen.bounds_L))),
                   fmt::format("with {}, which is written of the {}, it lies on it",
                               written_as(value), collision_fits ? "collision" : "visual"),
                   value,
                   collision_fits ? &touched : &seen,
                   decided};
}

std::optional<Elsewhere> find(std::uint32_t link, const std::vector<SeenShape>& all,
                              const model::Root& root) {
  // Where several are scattered, that is how the link was made.
  std::vector<const SeenShape*> scattered;
  for (const SeenShape& one : all) {
    if (is_apart(one, all)) scattered.push_back(&one);
  }
  std::optional<Elsewhere> farthest;
  double most = -1;
  if (scattered.size() > 1 && all.size() > 2) return std::nullopt;
  const bool two = scattered.size() == 2 && all[0].is_collision() != all[1].is_collision();
  const SeenShape* off = two ? off_mass(all, root.links[link]) : nullptr;
  if (off != nullptr) {
    auto found = apart_from_mass(*off, off == &all[0] ? all[1] : all[0]);
    if (found) return found;
  }
  for (const SeenShape* one : scattered) {
    auto found = apart(*one, all);
    const double away = length(one->pose->pose.value.translation);
    if (!found || away <= most) continue;
    most = away;
    farthest = std::move(found);
    // Either may be where it belongs; but a visual that is far off is seen.
    farthest->decided = !two || off == one || (off == nullptr && one->is_collision());
  }
  return farthest ? std::move(farthest) : beside_its_like(all, root.links[link]);
}

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const std::size_t count = root.links[i].collisions.size() + root.links[i].visuals.size();
    if (count < 2 || !root.own(root.links[i].site)) continue;
    if (!context.assembled().links[i].complete()) continue;
    const std::vector<SeenShape> all = seen_shapes(i, context);
    constexpr std::size_t kMax = 100;  // each is compared with all others
    if (all.size() < 2 || all.size() > kMax) continue;
    const auto found = find(i, all, root);
    if (!found) continue;
    const model::PoseField& pose = *found->shape->pose;
    Finding finding{
        .where = pose.pose.written ? place_of(pose, context) : found->shape->geometry->site.name,
        .message = found->message,
        .subject = subject_of_shape(*found->shape, context),
        .help = found->help,
        .fix = found->decided ? translation_fix(pose, found->value, context) : std::nullopt};
    if (found->beside && root.own(found->beside->geometry->site))
      finding.related = {
          {found->beside->geometry->site.name, std::string("the ") + role_name(*found->beside)}};
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "shape-misplaced",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a collision or visual is far from the other shapes of its link",
      .why = "What is seen is not what is touched: the robot collides with nothing, or with what "
             "is not there. Either a slip in the origin is undone and the shape lies with the "
             "others (millimeters, a decimal point, a sign), or a collision and a visual of one "
             "size are in two places. Shapes are compared as boxes.",
      .what_to_do = "Write the origin in meters, in the frame of the link, as that of the other "
                    "shape.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_misplaced
