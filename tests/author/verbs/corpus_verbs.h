// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The verbs of `rigor edit` as a test over real models applies them, with what takes each back.
//
//   for (const CorpusVerb& verb : corpus_verbs()) {
//     const Change change = verb.change(edited);
//     …
//   }

#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/verbs/lump/lump.h>
#include <rigor/author/verbs/mirror.h>
#include <rigor/author/verbs/move_frame.h>
#include <rigor/author/verbs/prefix.h>
#include <rigor/author/verbs/remove.h>
#include <rigor/author/verbs/reroot.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/author/verbs/scale.h>
#include <rigor/author/verbs/set_value.h>
#include <rigor/author/verbs/simplify/simplify.h>
#include <rigor/author/verbs/split.h>

#include "support/part.h"

namespace rigor::author {

enum class Comments { kAll, kSome };

struct CorpusVerb {
  std::string name;
  std::function<Change(const EditedModel&)> change;
  /// Made of the model before, for the model after; none where nothing takes the verb back.
  std::function<Change(const EditedModel& before, const EditedModel& after)> inverse = {};
  /// What that restores; the robot before when absent.
  std::function<robot::Robot(const EditedModel& before)> restored = {};
  Comments comments = Comments::kAll;  ///< that are there afterwards
  std::size_t least = 200;             ///< models of the corpus that it applies to
};

/// A link without children, by the file's order.
inline std::optional<std::string> some_leaf(const EditedModel& edited) {
  const robot::Robot& robot = edited.robot;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].carrier == robot::kNoIndex || robot.bodies[i].span.nowhere()) continue;
    const std::vector<bool> tree = subtree_of(robot, i);
    if (std::count(tree.begin(), tree.end(), true) == 1) return robot.bodies[i].name;
  }
  return std::nullopt;
}

/// The first link of the file that fits, from the root downwards.
template <class Fits>
std::optional<std::string> first_link(const EditedModel& edited, const Fits& fits) {
  for (const std::uint32_t i : edited.robot.order) {
    const robot::Body& body = edited.robot.bodies[i];
    if (!body.span.nowhere() && fits(body)) return body.name;
  }
  return std::nullopt;
}

inline bool is_carried(const robot::Body& body) { return body.carrier != robot::kNoIndex; }

inline CorpusVerb prefix_verb() {
  return {.name = "prefix",
          .change = [](const EditedModel& edited) { return prefixed(edited, "left_", {}); },
          .inverse = [](const EditedModel&,
                        const EditedModel& after) { return unprefixed(after, "left_", {}); },
          .least = 300};
}

inline CorpusVerb scale_verb() {
  return {.name = "scale",
          .change = [](const EditedModel& edited) { return scaled(edited, 1.7); },
          .inverse = [](const EditedModel&,
                        const EditedModel& after) { return scaled(after, 1 / 1.7); },
          .least = 300};
}

inline CorpusVerb reroot_verb() {
  const auto restored = [](const EditedModel& before) {
    robot::Robot robot = before.robot;
    if (!before.is_urdf()) return robot;
    // A URDF's root gets the frame of the joint that carried it in between.
    const auto leaf = some_leaf(before);
    const robot::Joint& joint = robot.joints[path_to_root(robot, before.body_index(*leaf)).back()];
    const std::uint32_t root = joint.parent;
    describe_in(robot, root, model::Pose(joint.X_PJ));
    robot.bodies[root].X_MB = {};
    robot::connect(robot);
    return robot;
  };
  return {.name = "reroot",
          .change =
              [](const EditedModel& edited) {
                const auto leaf = some_leaf(edited);
                return leaf ? rerooted(edited, *leaf) : refusal("one link");
              },
          .inverse =
              [](const EditedModel& before, const EditedModel& after) {
                const auto leaf = some_leaf(before);
                const std::vector<std::uint32_t> path =
                    path_to_root(before.robot, before.body_index(*leaf));
                return rerooted(after,
                                before.robot.bodies[before.robot.joints[path.back()].parent].name);
              },
          .restored = restored};
}

inline CorpusVerb remove_verb() {
  return {.name = "remove",
          .change =
              [](const EditedModel& edited) {
                const auto leaf = some_leaf(edited);
                return leaf ? removed(edited, *leaf, Subtree::kRefused, {}) : refusal("one link");
              },
          .comments = Comments::kSome};
}

inline CorpusVerb extract_verb() {
  return {.name = "extract",
          .change =
              [](const EditedModel& edited) {
                for (const std::uint32_t i : edited.robot.order) {
                  if (is_carried(edited.robot.bodies[i]))
                    return extracted(edited, edited.robot.bodies[i].name, {});
                }
                return refusal("one link");
              },
          .comments = Comments::kSome};
}

inline CorpusVerb mirror_verb() {
  const auto link = [](const EditedModel& edited) {
    return first_link(edited, is_carried).value_or(edited.robot.bodies.front().name);
  };
  return {
      .name = "mirror",
      .change = [link](const EditedModel& edited) { return mirrored(edited, link(edited), {}); },
      .inverse = [link](const EditedModel& before,
                        const EditedModel& after) { return mirrored(after, link(before), {}); }};
}

inline CorpusVerb move_frame_verb() {
  const model::Pose X{{0.1, -0.2, 0.3}, model::from_rpy(0.4, -0.5, 0.6)};
  const auto root = [](const EditedModel& edited) {
    return first_link(edited, [](const robot::Body&) { return true; }).value_or("");
  };
  return {.name = "move_frame",
          .change = [=](const EditedModel& edited) { return with_frame(edited, root(edited), X); },
          .inverse =
              [=](const EditedModel& before, const EditedModel& after) {
                return with_frame(after, root(before), inverse(X));
              },
          .least = 300};
}

/// Of the first link that a joint carries, or of the only one.
inline CorpusVerb set_pose_verb() {
  const auto name = [](const EditedModel& edited) {
    return first_link(edited, is_carried).value_or(edited.robot.bodies.front().name);
  };
  const auto pose = [name](const EditedModel& edited) -> std::optional<model::Pose> {
    const auto link = edited.link(name(edited));
    if (!link) return std::nullopt;
    if (!edited.is_urdf()) return edited.root()[link].pose.pose.value;
    const std::uint32_t carrier = edited.robot.bodies[edited.body_index(name(edited))].carrier;
    if (carrier == robot::kNoIndex) return std::nullopt;
    return edited.root()[edited.joint(edited.robot.joints[carrier].name)].pose.pose.value;
  };
  const model::Pose X{{0.1, -0.2, 0.3}, model::from_rpy(0.4, -0.5, 0.6)};
  return {.name = "set_pose",
          .change =
              [=](const EditedModel& edited) {
                return pose(edited) ? with_pose(edited, name(edited), X) : refusal("one link");
              },
          .inverse =
              [=](const EditedModel& before, const EditedModel& after) {
                return with_pose(after, name(before), *pose(before));
              }};
}

/// Of the first joint with limits.
inline CorpusVerb set_limit_verb() {
  const auto joint = [](const EditedModel& edited) -> const model::Joint* {
    for (const model::Joint& each : edited.root().joints) {
      const bool limited =
          each.type == model::JointType::kRevolute || each.type == model::JointType::kPrismatic;
      if (limited && each.model == edited.model && edited.joint(each.name.value) &&
          !each.axes.empty() && each.axes.front().lower.written && each.axes.front().upper.written)
        return &each;
    }
    return nullptr;
  };
  return {.name = "set_limit",
          .change =
              [joint](const EditedModel& edited) {
                const model::Joint* const found = joint(edited);
                return found == nullptr
                           ? refusal("no joint with limits")
                           : with_limits(edited, found->name.value, {.lower = -0.1, .upper = 0.2});
              },
          .inverse =
              [joint](const EditedModel& before, const EditedModel& after) {
                const model::Joint& was = *joint(before);
                return with_limits(
                    after, was.name.value,
                    {.lower = was.axes.front().lower.value, .upper = was.axes.front().upper.value});
              },
          .least = 180};
}

inline CorpusVerb lump_verb() {
  return {.name = "lump",
          .change = [](const EditedModel& edited) { return lumped(edited, {}); },
          .comments = Comments::kSome,
          .least = 100};
}

/// The first link with two shapes or more loses the last one, with a third of its mass; lumped, it is the old one.
inline CorpusVerb split_verb() {
  const model::Pose X_LN{{0.1, -0.2, 0.3}, model::from_rpy(0.4, -0.5, 0.6)};
  const auto link_to_split = [](const EditedModel& edited) -> std::optional<std::string> {
    for (const robot::Body& body : edited.robot.bodies) {
      if (!edited.link(body.name) || body.name.find("::") != std::string::npos) continue;
      if (body.visuals.size() + body.collisions.size() > 1 && body.mass.mass > 0) return body.name;
    }
    return std::nullopt;
  };
  const auto change = [=](const EditedModel& edited) {
    const auto link = link_to_split(edited);
    if (!link) return refusal("no link with two shapes");
    // Then it cannot be lumped back.
    const std::string why = lumped(edited, {}).refused;
    if (why.find("closes a loop") != std::string::npos || why.starts_with("a part of it"))
      return refusal(why);
    const robot::Body& body = edited.robot.bodies[edited.body_index(*link)];
    SplitRequest request;
    request.name = "cut_off";
    request.X_LN = X_LN;
    const std::vector<robot::Part>& parts = body.visuals.empty() ? body.collisions : body.visuals;
    request.take = {(body.visuals.empty() ? "collision/" : "visual/") +
                    std::to_string(parts.size())};
    request.share = SplitMass::kGiven;
    request.mass = body.mass.mass / 3;
    return split(edited, *link, request);
  };
  const auto restored = [=](const EditedModel& before) {
    robot::Robot robot = before.robot;
    if (before.is_urdf() || before.root()[before.model].version < 7) return robot;
    // The names stay, as frames.
    const std::string link = *link_to_split(before);
    const std::uint32_t body = before.body_index(link);
    const model::Pose X_ML =
        compose(inverse(*before.frames.pose(before.model)), *before.frames.pose(before.link(link)));
    const model::Pose X_BN = compose(inverse(robot.bodies[body].X_MB), compose(X_ML, X_LN));
    robot.frames.push_back({"cut_off", body, X_BN, {}});
    robot.frames.push_back({link + "_to_cut_off", body, X_BN, {}});
    return robot;
  };
  return {.name = "split",
          .change = change,
          .inverse = [](const EditedModel&,
                        const EditedModel& after) { return lumped(after, {"cut_off"}); },
          .restored = restored};
}

/// Of robots with so many bytes of meshes at most, as a fit of a large one takes seconds, and a minute with sanitizers.
inline CorpusVerb simplify_verb(std::uintmax_t most) {
  return {.name = "simplify",
          .change =
              [most](const EditedModel& edited) {
                std::uintmax_t bytes = 0;
                for (const robot::Body& body : edited.robot.bodies) {
                  for (const robot::Part& part : body.collisions) {
                    if (part.shape.kind == "mesh" && !part.shape.path.empty())
                      bytes += std::filesystem::file_size(part.shape.path);
                  }
                }
                if (bytes == 0 || bytes > most) return refusal("no small meshes");
                return simplified(edited, {});
              },
          .comments = Comments::kSome,
          .least = 30};
}

inline std::vector<CorpusVerb> corpus_verbs(std::uintmax_t most_mesh_bytes) {
  return {prefix_verb(),    scale_verb(),  reroot_verb(),     remove_verb(),
          extract_verb(),   mirror_verb(), move_frame_verb(), set_pose_verb(),
          set_limit_verb(), lump_verb(),   split_verb(),      simplify_verb(most_mesh_bytes)};
}

}  // namespace rigor::author
