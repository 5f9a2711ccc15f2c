// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/assembly/written_places.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::origin_looks_like_millimeters {

// Times as far from its link's origin as anything else of the model is from its own, and than any
// shape reaches. A unit is a factor of 100 or 1000.
constexpr double kTimesFarther = 8;
constexpr double kMin = 0.3;  // m

// The same of joints: an arm may be on a column that is not drawn.
constexpr double kTimesFartherOfJoint = 4;

// Two or three numbers do not say how large a robot is.
constexpr std::size_t kFewestParts = 3;

/// An inertial, a collision, a visual or a URDF's joint.
struct Part {
  const model::PoseField* pose = nullptr;
  std::string subject;
  double offset = 0;  ///< m, from the link's origin
  bool is_joint = false;
};

/// The parts of a model, and the lengths that they are compared with.
struct Proportions {
  std::vector<Part> parts;
  double longest_shape = 0;  ///< m

  double without(std::size_t part) const {
    double longest = longest_shape;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i != part) longest = std::max(longest, parts[i].offset);
    }
    return longest;
  }
};

void add(const model::PoseField& pose, std::string subject, Proportions& model) {
  if (!pose.pose.written) return;
  model.parts.push_back(
      {&pose, std::move(subject), model::length(pose.pose.value.translation), false});
}

/// Empty for what is too near to be reported.
template <class Entity>
std::string subject_if_far(const model::PoseField& pose, const Entity& entity,
                           const Context& context) {
  const bool far = model::length(pose.pose.value.translation) >= kMin;
  return far ? context.subject(entity) : std::string();
}

/// m, from the shape's own origin to its farthest point: a mesh may be drawn far from it.
double reach(const mesh::Bounds& bounds_S) {
  return model::length({std::max(std::abs(bounds_S.min.x), std::abs(bounds_S.max.x)),
                        std::max(std::abs(bounds_S.min.y), std::abs(bounds_S.max.y)),
                        std::max(std::abs(bounds_S.min.z), std::abs(bounds_S.max.z))});
}

std::map<model::Id<model::Model>, Proportions> proportions(Context& context) {
  const model::Root& root = context.root();
  const robot::Assembled& robot = context.assembled();
  std::map<model::Id<model::Model>, Proportions> models;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    Proportions& model = models[robot.links[i].top];
    add(link.inertial.pose, subject_if_far(link.inertial.pose, link, context), model);
    for (const auto id : link.collisions)
      add(root[id].pose, subject_if_far(root[id].pose, root[id], context), model);
    for (const auto id : link.visuals)
      add(root[id].pose, subject_if_far(root[id].pose, root[id], context), model);
    for (const std::uint32_t shape : robot.links[i].shapes) {
      model.longest_shape = std::max(model.longest_shape, reach(robot.shapes[shape].bounds_S));
    }
    if (!context.is_urdf() || !robot.links[i].carrier) continue;
    const model::Joint& joint = root[robot.links[i].carrier];
    add(joint.pose, context.subject(joint), model);
    if (joint.pose.pose.written) model.parts.back().is_joint = true;
  }
  return models;
}

/// The translation with a unit taken out, with which the part is no farther than others are.
std::optional<Undone> in_meters(const model::PoseField& pose, double longest,
                                const model::Root& root) {
  std::vector<Undone> changes = undone_slips(pose.pose.value.translation);
  std::erase_if(changes, [&](const Undone& one) { return model::length(one.value) > longest; });
  if (changes.empty()) return std::nullopt;
  return *likeliest(changes, pose, root);
}

void check(const model::Root& root, Context& context) {
  if (root.links.empty()) return;
  for (const auto& [top, model] : proportions(context)) {
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      const Part& part = model.parts[i];
      if (part.offset < kMin || !root.own(part.pose->site)) continue;
      const double longest = model.without(i);
      const double times = part.is_joint ? kTimesFartherOfJoint : kTimesFarther;
      if (!(longest > 0) || part.offset < times * longest || model.parts.size() < kFewestParts)
        continue;
      const auto change = in_meters(*part.pose, longest, root);
      if (!change) continue;
      context.report(
          {.where = place_of(*part.pose, context),
           .message =
               fmt::format("the origin is {:.3g} m away from {}, and nothing else in the model is "
                           "longer than {:.3g} m",
                           part.offset, part.is_joint ? "the parent's" : "the link's", longest),
           .subject = part.subject,
           .help = fmt::format("write {}: {}", written_as(change->value), change->slip),
           .fix = translation_fix(*part.pose, change->value, context),
           .severity = part.offset < kTimesFarther * longest ? std::optional(Severity::kInfo)
                                                             : std::nullopt});
    }
  }
}

Rule rule() {
  return {
      .name = "origin-looks-like-millimeters",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the origin of a part of a link is written in millimeters or centimeters",
      .why =
          "The part is far outside of the robot: a collision touches what is elsewhere, a center "
          "of mass makes the link a pendulum. All lengths are in meters, and no parser doubts "
          "them. The part is compared with the other origins of its model and the sizes of its "
          "shapes, so that it is found without its meshes, too.",
      .what_to_do = "Write the origin in meters, in the frame of the link.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::origin_looks_like_millimeters
