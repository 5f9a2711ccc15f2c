// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a comparison: each adds what it finds; private to the room.

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/robot/compare_poses.h>

namespace rigor::robot {

/// kg: a microgram, less than any link weighs. SDF has no link without mass, so one that moves gets less
/// than this, and two of no more are the same.
inline constexpr double kNothing = 1e-9;

struct Comparison {
  const Robot& a;
  const Robot& b;
  const Robot& b_as_read;  ///< where links between joints in a row have masses of their own
  const Correspondence& names;
  const Tolerance& tolerance;
  const Match& match;
  const TwinPoses& poses;
  const std::vector<BodyShift>& shifts;
  std::vector<Difference> found;
  /// Of A's bodies: something is told that explains why its subtree is
  /// elsewhere.
  std::vector<bool> explained;

  Difference& add(DifferenceKind kind, std::string subject_a, std::string subject_b, Span span_a,
                  Span span_b) {
    Difference difference;
    difference.kind = kind;
    difference.a = std::move(subject_a);
    difference.b = std::move(subject_b);
    difference.span_a = span_a;
    difference.span_b = span_b;
    found.push_back(std::move(difference));
    return found.back();
  }
};

/// Links of A in order, then those that only B has (compare_links.cc).
void compare_links(Comparison& comparison);
/// The collisions and visuals of a matched pair (compare_shapes.cc).
void compare_shapes(Comparison& comparison, std::uint32_t body);
/// (compare_joints.cc)
void compare_joints(Comparison& comparison);
/// Frames, and links that are nothing but frames (compare_frames.cc).
void compare_frames(Comparison& comparison);
/// Sums, world poses, placement (compare_whole.cc). Last: it tells what the
/// others leave unexplained.
void compare_whole(Comparison& comparison);

/// "joint elbow"
inline std::string subject(std::string_view kind, const std::string& name) {
  return std::string(kind) + " " + name;
}

inline std::vector<double> pose_numbers(const model::Pose& X) {
  return {X.translation.x, X.translation.y, X.translation.z, X.rotation.w,
          X.rotation.x,    X.rotation.y,    X.rotation.z};
}

inline std::vector<double> tensor_numbers(const mass::Inertia& i) {
  return {i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz};
}

}  // namespace rigor::robot
