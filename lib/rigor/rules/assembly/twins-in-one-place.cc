// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::twins_in_one_place {

using model::Vector3;

// Parts that are nearer than this, as a share of what they are long, are in each other.
constexpr double kSamePlace = 0.02;

/// Where two links are placed, when both are placed from the same frame.
struct Placed {
  const model::PoseField* a = nullptr;
  const model::PoseField* b = nullptr;
};

std::optional<Placed> placed_alike(const robot::Twins& pair, Context& context) {
  const model::Root& root = context.root();
  const robot::Assembled& robot = context.assembled();
  if (!context.is_urdf()) {
    const model::PoseField& a = root.links[pair.a].pose;
    const model::PoseField& b = root.links[pair.b].pose;
    if (a.relative_to.value != b.relative_to.value) return std::nullopt;
    return Placed{&a, &b};
  }
  const auto of_a = robot.links[pair.a].carrier, of_b = robot.links[pair.b].carrier;
  if (!of_a || !of_b) return std::nullopt;
  if (context.frames().ends(of_a).parent != context.frames().ends(of_b).parent) return std::nullopt;
  return Placed{&root[of_a].pose, &root[of_b].pose};
}

bool in_one_place(const robot::Twins& pair, const robot::Assembled& robot) {
  const auto a = robot.bounds_W({pair.a}), b = robot.bounds_W({pair.b});
  if (!a || !b) return false;
  const double apart = std::max(length(a->min - b->min), length(a->max - b->max));
  return apart < kSamePlace * mesh::diagonal(*a);
}

/// Where nobody knows the shapes, by the links' frames. Fingers of a gripper may begin in one place, and move
/// along one line, or against each other.
bool frames_in_one_place(const robot::Twins& pair, Context& context) {
  constexpr double kAside = 0.02;  // m from the middle of what carries them: no finger's
  const robot::AssembledLink& a = context.assembled().links[pair.a];
  const robot::AssembledLink& b = context.assembled().links[pair.b];
  if (a.unknown == 0 || b.unknown == 0 || !a.X_WL || !b.X_WL || !a.carrier || !b.carrier)
    return false;
  if (length(a.X_WL->translation - b.X_WL->translation) > kSamePlace * kAside) return false;
  const model::Joint& joint = context.root()[a.carrier];
  if (std::abs(joint.pose.pose.value.translation.y) < kAside && context.is_urdf()) return false;
  if (joint.type == model::JointType::kPrismatic) return false;
  const auto axis_a = context.frames().axis(a.carrier, 0);
  const auto axis_b = context.frames().axis(b.carrier, 0);
  return !axis_a || !axis_b || dot(*axis_a, *axis_b) > 0;
}

/// y, to the left in ROS and SDF. Fingers that move along another axis may begin in one place.
constexpr std::size_t kLateral = 1;

void report(const robot::Twins& pair, const Placed& placed, Context& context) {
  const model::Root& root = context.root();
  // To the left is y above zero.
  const bool first = placed.a->pose.value.translation.*kCoordinates[kLateral] < 0;
  const model::PoseField& pose = first ? *placed.a : *placed.b;
  const model::PoseField& other = first ? *placed.b : *placed.a;
  const std::uint32_t link = first ? pair.a : pair.b;
  Vector3 value = pose.pose.value.translation;
  value.*kCoordinates[kLateral] = -1 * value.*kCoordinates[kLateral];
  const auto carrier = context.assembled().links[link].carrier;
  context.report({.where = place_of(pose, context),
                  .message = fmt::format("link '{}' is in the same place as its twin '{}', at {}",
                                         root.links[link].name.value,
                                         root.links[first ? pair.b : pair.a].name.value,
                                         written_as(pose.pose.value.translation)),
                  .subject = context.is_urdf() && carrier ? context.subject(root[carrier])
                                                          : context.subject(root.links[link]),
                  .related = {{place_of(other, context), "its twin's"}},
                  .help = fmt::format("with the other sign of {} it is on the other side: {}",
                                      coordinate_name(kLateral), written_as(value)),
                  .fix = translation_fix(pose, value, context)});
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2) return;
  for (const robot::Twins& pair : context.assembled().link_twins) {
    const auto placed = placed_alike(pair, context);
    if (!placed || !placed->a->pose.written || !placed->b->pose.written) continue;
    if (!in_one_place(pair, context.assembled()) && !frames_in_one_place(pair, context)) continue;
    if (placed->b->pose.value.translation.y != 0) report(pair, *placed, context);
  }
}

Rule rule() {
  return {
      .name = "twins-in-one-place",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the left and the right of a pair are in the same place",
      .why = "The robot has both wheels or legs on one side: it falls over, and where its links "
             "collide the two push each other apart. The name of one says left, that of the other "
             "right, and their origins and shapes are the same: the sign of one coordinate was "
             "lost when the block was copied.",
      .what_to_do = "Change the sign of the coordinate that goes to the side; y is to the left.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::twins_in_one_place
