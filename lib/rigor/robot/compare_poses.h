// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the bodies of two robots are at the same joint positions, and which
// body is the cause when they differ; private to the room.
//
// A body's own frame is that of its joint, and what is in it may be elsewhere
// in that frame: so each pair of bodies has a shift E, the rigid motion in the
// frame of B's body that carries what A's body holds there to where B's holds
// it (the identity, but for a link that moved as a whole). A pair is the cause
// when it is elsewhere in the nearest matched body above, that body's shift
// allowed for.

#pragma once

#include <vector>

#include <rigor/robot/compare_match.h>
#include <rigor/robot/compare_near.h>

namespace rigor::robot {

/// The two robots at the same joint positions.
class TwinPoses {
 public:
  TwinPoses(const Robot& a, const Robot& b, const Match& match, std::size_t configurations);

  std::size_t count() const { return in_a_.size(); }
  const std::vector<model::Pose>& all_a(std::size_t configuration) const {
    return in_a_[configuration];
  }
  const std::vector<model::Pose>& all_b(std::size_t configuration) const {
    return in_b_[configuration];
  }
  /// Of a body in the frame of the reference body.
  const model::Pose& a(std::size_t configuration, std::uint32_t body) const {
    return in_a_[configuration][body];
  }
  const model::Pose& b(std::size_t configuration, std::uint32_t body) const {
    return in_b_[configuration][body];
  }

 private:
  std::vector<std::vector<model::Pose>> in_a_, in_b_;
};

/// What a matched pair is about, beside its subtree.
struct BodyShift {
  model::Pose E;
  Apart frame;                    ///< at rest, its own frame in what it hangs on
  Apart content;                  ///< at rest, what it holds likewise
  Apart motion;                   ///< the worst of the other configurations, rest allowed for
  std::size_t configuration = 0;  ///< of that
  bool frame_moved = false;
  bool content_moved = false;  ///< as a whole, in another way than with the frame
  bool motion_differs = false;
};

/// Of every body of A; those without a counterpart are as they are made.
std::vector<BodyShift> shifts(const Robot& a, const Robot& b, const Match& match,
                              const TwinPoses& poses, const Tolerance& tolerance);

/// Collisions or visuals that are meant to be the same: indices in A and in B;
/// kNoIndex for none.
struct PartPair {
  std::uint32_t a = kNoIndex;
  std::uint32_t b = kNoIndex;
};

/// By name, the rest in their order: those of one kind of shape first.
std::vector<PartPair> pair_parts(const std::vector<Part>& a, const std::vector<Part>& b);

}  // namespace rigor::robot
