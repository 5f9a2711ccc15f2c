// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a link stands to the one that carries it while its joint moves, all other joints at zero.
//
//   const RigidGroups rigid(root, frames, robot);
//   if (const auto sides = sides_of(joint, root, frames, robot, rigid)) see(sides->at(0.5).gap);
//
// Links that are fixed to each other count as one; boxes represent their shapes.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/assembled/oriented_box.h>

namespace rigor::robot {

/// Links by the fixed joints that carry them.
struct RigidGroups {
  RigidGroups(const model::Root& root, const model::Frames& frames, const Assembled& robot);

  /// Whether fixed joints alone lead from `base` to the link; so for the link itself.
  bool is_fixed_to(std::uint32_t link, std::uint32_t base) const;

  Links fixed_to;              ///< of each link the one it is fixed to; itself for one that moves
  Links leaders;               ///< of each link the one that carries all that is fixed to it
  std::vector<Links> members;  ///< of each leader itself and what is fixed to it; in order
};

/// Positions of a joint, rad or m.
struct Range {
  double lower = 0;
  double upper = 0;
};

/// Of a joint that turns or slides; nothing without two limits that are finite and ascend, nor where they are a hundred
/// or more apart, which is how files say that there are none.
std::optional<Range> limited_range(const model::Joint& joint);

/// How the child stands to the parent.
struct Stand {
  double position = 0;  ///< of the joint, rad or m
  double gap = 0;       ///< m, between child and parent
  double inside = 0;    ///< share of the child that is inside of the parent, 0 to 1
};

/// What a joint that turns or slides has on its two sides, at zero.
struct JointSides {
  std::vector<OrientedBox> child;
  std::vector<OrientedBox> parent;
  model::Vector3 pivot_W;  ///< m
  model::Vector3 axis_W;   ///< unit vector
  bool slides = false;

  Stand at(double position) const;
  /// At each of `positions_in`.
  std::vector<Stand> between(const Range& range) const;
  /// `Stand::inside` alone, which costs less.
  double inside(double position) const;
};

/// The limits, the middle between them, three positions on either side of it, and zero where it is within; in ascending
/// order.
std::vector<double> positions_in(const Range& range);

/// Nothing for a joint of another type, one that carries nothing, and where the size of a shape on either side is not
/// known.
std::optional<JointSides> sides_of(model::Id<model::Joint> joint, const model::Root& root,
                                   const model::Frames& frames, const Assembled& robot,
                                   const RigidGroups& rigid);

}  // namespace rigor::robot
