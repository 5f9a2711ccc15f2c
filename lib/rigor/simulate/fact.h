// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a simulation has to say about a model, as data without words; a row of the tables in
// `rules/simulate/` turns each kind into a finding.
//
//   facts.push_back({.kind = FactKind::kTips, .where = body.where, .subject = "robot/link base",
//                    .value = 1.2, .limit = 0.52, .phase = "settle"});

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/text/span.h>

namespace rigor::simulate {

enum class FactKind : std::uint8_t {
  // What an engine cannot take: nothing is run, the verdict is `invalid`.
  kUnreadable,         ///< no model, no pose, an include that does not exist; `name` says what
  kNoMass,             ///< of a body that moves; `name`: "all" of a model that is only drawn
  kNotFinite,          ///< a number; `name` says which
  kInertiaImpossible,  ///< no rigid body has it
  kShapeSize,          ///< not positive
  kAxisZero,
  kLimitsCrossed,
  /// A setting of the world's solver that the engine does not take. `name` says which: the step, iters,
  /// sor, erp, cfm, max_contacts, the surface layer, the correcting speed.
  kStep,
  kEngineRefused,  ///< the engine stopped; `name` is what it said
  kTooLarge,       ///< more bodies, shapes or triangles than are simulated
  // What is not as it is written: info.
  kNothingMoves,     ///< all is static, or there is no link: there is nothing to run
  kMeshMissing,      ///< the collision is left out
  kMeshAsPrimitive,  ///< `name`: cylinder; `value`: the share that it fills
  kMeshAsHull,       ///< open, too large, or one that moves and is convex; `name` says why
  kShapeAsHull,      ///< an ellipsoid, cone or polyline
  kShapeIgnored,     ///< an image; `name` says which
  kJointEmulated,    ///< screw, gearbox, mimic; `name` says how
  kJointIgnored,
  kElementIgnored,  ///< `name`: the element's; the model relies on what this engine lacks
  kDampingAsNone,
  kStartMoved,  ///< zero is outside the joint's limits: it begins at `value`
  // What a run shows. Each is a metric beyond its limit; `value` and `limit` in the metric's unit, `name`
  // its id (of two shapes, the other one).
  kExplodes,  ///< not finite, or far away
  kTooFast,
  kEnergyGained,
  kSpawnedInGround,
  kSpawnedAbove,  ///< `value`: infinite where nothing is below
  kSelfOverlap,
  kNeverSettles,
  kRestless,  ///< residual speed at rest
  kCreeps,
  kUnbalanced,  ///< what the ground bears is not the weight
  kTips,
  kNearlyTips,  ///< support margin
  kSinks,
  kFalls,  ///< nothing holds it: no contact with the ground
  kAnchorError,
  kLimitViolated,
  kJointJitters,
  kStiffControl,  ///< kd·h/I
  kSelfCollides,
  kDriveSlips,  ///< drive.ratio
  kDriveBackwards,
  kDriveDrifts,
  kDriveBounces,
  kTurnOff,
  kDoesNotBrake,
  kPushedOver,
  kJointShort,       ///< a joint does not reach its limit
  kJointOverloaded,  ///< the effort that a joint needs is above its limit
  kDoesNotHold,
  kTiltsEarly,  ///< at a smaller angle than its geometry says
  kStepSensitive,
  kSeedSensitive,
  kSolverDiffers,
  kEnginesDiffer,  ///< `name` says in what; `help`, what explains it
  kNoMotor,        ///< of a model: no motor holds its joints, which `name` lists; `value`: how many
  kHeldUp,         ///< it does not stand by itself, and was judged with its base held
  /// Wheels that cannot drive: `name`: which; `value`: m above the ground, or 0 where `limit` (rad) is all they turn.
  kWheelsMiss,
  kAssertion,  ///< of a scenario; `name` is the assertion's
  // Why, found in the model (simulate/advice/advice.h). They go along with what a run shows.
  kCauseInertia,         ///< `value`: times the moment of the link's shapes; `name`: which moment
  kCauseDefaultInertia,  ///< nothing is written: 1 kg and the identity; `value` and `name` as above
  /// A mass is written and no inertia: the identity; `value` and `name` as above.
  kCauseInertiaNotWritten,
  kCauseMassRatio,  ///< of two bodies that a joint connects; `name`: the other's
  kCauseWheelOffCenter,
  kCauseWheelAxis,  ///< `name`: "tilted" against the cylinder's, or "reversed": it rolls backward
  kCauseCasterFriction,
  kCauseTopHeavy,
  kCauseMeshWheel,
  kCauseStartOutsideLimits,
  kCauseNoCollision,
  kCauseEffort,  ///< too little for the load
  /// `name`: "kinematic", "gravity" that acts on others of the model, "no gravity" on any, "max_contacts" of 0.
  kCauseFlag,
  kCauseWheelFriction,  ///< of a wheel that drives; `value`: the larger of mu and mu2
  kCauseWheelRadii,     ///< of two on one axle; `value`: m, `limit`: the other's, `name`: the other
  kCauseSoftContact,    ///< `value`: m that it sinks where an engine honors kp
  kCauseMeshMissing,    ///< `value`: how many of a model's collisions, `limit`: of how many
  kCauseMeshScale,  ///< `value`: m, its longest side; `limit`: m, that of a shape with the link's inertia
};

struct Fact {
  FactKind kind = FactKind::kUnreadable;
  Span where;           ///< of the value, or of the element's name; may be nowhere
  std::string subject;  ///< as in a diagnostic: "robot/link wheel"
  double value = 0;
  double limit = 0;
  std::string name;     ///< see the kinds
  bool slides = false;  ///< it is about a joint that does: m for rad, N for N·m
  std::string test;     ///< in which it was seen; empty before any run
  bool severe = true;   ///< a fail (or invalid), not a warn
  std::string help;     ///< what to do, in place of the kind's own words
};

using Facts = std::vector<Fact>;

}  // namespace rigor::simulate
