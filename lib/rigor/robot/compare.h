// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether two robots are the same, and if not, in what. Nothing is taken on trust from the way they
// were made: names are matched, then every mass, collision, visual and joint frame is placed at rest and
// at random joint positions and held against its counterpart.
//
//   std::vector<Difference> differences = compare(robot_of(sdf…), robot_of(urdf…), {names});
//   for (const Difference& d : differences) say(to_string(d.kind), d.a, d.b, d.distance);
//
// One thing that differs is one difference: what a moved joint carries is not reported again. A link that
// was made one with its neighbor (lumped) is reported as missing, not as a change of mass.

#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/robot/robot.h>

namespace rigor::robot {

/// What has no part in motion and mass: massless bodies without shapes on fixed joints, and these
/// joints, that only one of the two has; new names of collisions and visuals. A frame that only one has
/// is reported in any case.
enum class Helpers : std::uint8_t { kIgnored, kReported };

/// Model pose, pose of the root, static: what one of two formats may have no place for.
enum class Placement : std::uint8_t { kIgnored, kReported };

/// Which names of A are which of B. A name that is not in it is the same in B, or the same with `::`
/// written as `__`.
struct Correspondence {
  std::map<std::string, std::string> links;
  /// A joint that was written as several: the names for its axes in their order. The joints and bodies
  /// in between that are not in A are its substitute and no differences.
  std::map<std::string, std::vector<std::string>> joints;
  /// Bodies of A that may be part of another one of A in B, and that one: both are fixed to each other.
  /// A body that B has is compared as it is.
  std::map<std::string, std::string> held_by = {};
  /// Whether B begins at the world, so that A's pose in it is the place of what hangs there.
  bool from_world = false;
  /// Stands in B for an effort, velocity or position without a limit.
  double unlimited = std::numeric_limits<double>::infinity();
  /// Whether both are of one format: then a visual without a material has no color, and not the format's default.
  bool one_format = false;
  Helpers helpers = Helpers::kIgnored;
  Placement placement = Placement::kIgnored;
};

struct Tolerance {
  double distance = 1e-9;  ///< m: a thousandth of what any machine can measure; rounding is 1e-15
  double angle = 1e-9;     ///< rad; asin-based extraction near a pitch of 90° is off by 1.5e-8
  double relative = 1e-9;  ///< of masses, moments, limits and sizes
  /// Random joint positions besides rest. Twenty tell apart whatever differs in motion: to agree by
  /// accident in one is improbable already.
  std::size_t configurations = 20;
};

enum class DifferenceKind : std::uint8_t {
  kLinkOnlyInA,
  kLinkOnlyInB,
  kLinkRenamed,  ///< the same joint holds it, or its content is the same
  kJointOnlyInA,
  kJointOnlyInB,
  kJointRenamed,  ///< it connects the same links
  kFrameOnlyInA,
  kFrameOnlyInB,
  kCollisionOnlyInA,
  kCollisionOnlyInB,
  kVisualOnlyInA,
  kVisualOnlyInB,
  kPartRenamed,  ///< collision or visual

  kJointMoved,   ///< its frame, in what it hangs on
  kJointMotion,  ///< in another way than by its place, type or axis
  kJointType,
  kJointParent,
  kJointChild,
  kJointAxis,
  kLower,
  kUpper,
  kEffort,
  kVelocity,
  kDamping,
  kFriction,
  kSpringReference,
  kSpringStiffness,
  kMimic,

  kLinkMoved,  ///< all that it holds, in the frame of its joint
  kMass,
  kCenterOfMass,
  kInertia,
  kCollisionMoved,
  kVisualMoved,
  kFrameMoved,
  kShape,  ///< another kind of shape
  kSize,
  kMesh,
  kColor,

  kTotalMass,    ///< these when no link's own difference explains it
  kTotalFirst,   ///< Σ m c
  kTotalSecond,  ///< about the root's origin
  kWorldPose,    ///< a thing is elsewhere though nothing it hangs on is reported as different
  kModelPose,
  kRootPose,  ///< of a root in the model
  kStatic,

  kSetting,            ///< of `what`, beside the robot (settings.h)
  kAttachmentOnlyInA,  ///< a sensor, a light, a plugin
  kAttachmentOnlyInB,
};

/// "joint-moved"; stable, for programs.
std::string_view to_string(DifferenceKind kind);

/// A value on one side: numbers, or words.
struct DifferenceValue {
  std::vector<double> numbers;
  std::string text;
};

struct Difference {
  DifferenceKind kind{};
  std::string a, b;  ///< subjects: "joint elbow", "collision arm/hull"; empty where it is not
  std::string what;  ///< of kSetting: "surface/friction/ode/mu"
  DifferenceValue from, to;
  std::string_view unit;  ///< of the numbers; empty when they have none
  double distance = 0;    ///< m: the greatest found; of a number, how far it is off
  double angle = 0;       ///< rad
  /// Where the greatest was found: 0 at rest, else that of `configurations`.
  std::size_t configuration = 0;
  Span span_a, span_b;
};

/// In the order of A's file, what only B has last. Links, then joints, then the whole.
std::vector<Difference> compare(const Robot& a, const Robot& b,
                                const Correspondence& correspondence = {},
                                const Tolerance& tolerance = {});

/// Joint positions that are the same on every machine: the first at rest, the others drawn in [-1, 1]
/// inside the limits, from a generator of its own. What follows is where its leader puts it.
std::vector<Positions> configurations(const Robot& robot, std::size_t count);

}  // namespace rigor::robot
