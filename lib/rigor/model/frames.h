// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where everything is: names resolved in their scopes, poses in the frame of the world (or, for a
// file with a model at the top, in that model's `__root__`), and forward kinematics.
//
// A frame has a pose relative to another (the pose graph) and is attached to another (so that in the
// end it moves with a link). Both graphs come from names, so both can break; what breaks them is
// kept in `problems()`, and what depends on it has no pose. Rules: SDFormat's "Pose frame semantics"
// proposal, as libsdformat 12 carries it out.
//
//   Frames frames(root);
//   if (auto X_WL = frames.pose(link_id)) draw(*X_WL);

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/model/names.h>

namespace rigor::model {

enum class FrameProblemKind : std::uint8_t {
  kRelativeToMissing,  ///< `name` is nothing in the scope
  kRelativeToCycle,    ///< `members` are the names, the first again at the end
  kAttachedToMissing,
  kAttachedToCycle,
  kExpressedInMissing,
  kParentMissing,  ///< of a joint
  kChildMissing,
  kChildIsWorld,
  kParentIsChild,  ///< both resolve to one link
  kCanonicalLinkMissing,
  kPlacementFrameMissing,
  kReservedReference,  ///< `__root__` or another internal name
};

struct FrameProblem {
  FrameProblemKind kind{};
  Span where;           ///< the reference's value
  std::string name;     ///< what it says
  std::string subject;  ///< who says it, as in a diagnostic's subject
  std::vector<std::string> members;
  std::vector<std::string> candidates;  ///< what exists in the scope
  Id<Model> model;                      ///< the scope that was searched, or
  Id<World> world;
};

/// Joint positions for forward kinematics, by scoped name: rad or m, per axis.
using JointPositions = std::map<std::string, std::array<double, 2>>;

class Frames {
 public:
  explicit Frames(const Root& root, const JointPositions& positions = {});

  /// Poses in the frame of the world or of `__root__`; nothing when a problem stands in the way.
  std::optional<Pose> pose(Id<Model> id) const { return at(models_, id.value); }
  std::optional<Pose> pose(Id<Link> id) const { return at(links_, id.value); }
  std::optional<Pose> pose(Id<Joint> id) const { return at(joints_, id.value); }
  std::optional<Pose> pose(Id<Frame> id) const { return at(frames_, id.value); }
  std::optional<Pose> pose(Id<Collision> id) const { return at(collisions_, id.value); }
  std::optional<Pose> pose(Id<Visual> id) const { return at(visuals_, id.value); }
  std::optional<Pose> pose(Id<Sensor> id) const { return at(sensors_, id.value); }
  std::optional<Pose> pose(Id<Light> id) const { return at(lights_, id.value); }

  /// An axis of a joint as a unit vector in the same frame as the poses.
  std::optional<Vector3> axis(Id<Joint> id, std::size_t index) const;

  /// The links a joint connects, after following frames, joints and models; `parent` is none for
  /// the world, both are none where they do not resolve.
  struct Ends {
    Id<Link> parent;
    Id<Link> child;
    bool parent_is_world = false;
  };
  const Ends& ends(Id<Joint> id) const { return ends_[id.value]; }

  /// The link a frame moves with; none for one that is fixed to the world.
  Id<Link> carrier(Id<Frame> id) const { return carriers_[id.value]; }

  /// The link a model's `__model__` frame moves with.
  Id<Link> canonical_link(Id<Model> id) const { return canonical_[id.value]; }

  const std::vector<FrameProblem>& problems() const { return problems_; }

  /// The names that were resolved, for whoever has one more.
  const Names& names() const { return names_; }

 private:
  friend class FrameSolver;
  friend class JointMover;
  using Poses = std::vector<std::optional<Pose>>;
  void move_joints(const Root& root, const JointPositions& positions);
  static std::optional<Pose> at(const Poses& poses, std::uint32_t index) {
    return index < poses.size() ? poses[index] : std::nullopt;
  }

  Names names_;
  Poses models_, links_, joints_, frames_, collisions_, visuals_, sensors_, lights_;
  std::vector<std::array<std::optional<Vector3>, 2>> axes_;
  std::vector<Ends> ends_;
  std::vector<Id<Link>> canonical_;
  std::vector<Id<Link>> carriers_;
  std::vector<FrameProblem> problems_;
};

}  // namespace rigor::model
