// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/advice/advice.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <rigor/simulate/advice/parts.h>
#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/metric/parts.h>
#include <rigor/simulate/mount.h>

namespace rigor::simulate {
namespace {

/// What a limit may be off of where the joint stands: it is drawn in degrees, written in radians.
constexpr double kOutsideLimits = 0.001;  // rad, m

constexpr std::size_t kMaxCauses = 3;

/// What can be behind a fact, the likeliest first.
std::vector<FactKind> kinds_behind(FactKind shown) {
  using enum FactKind;
  switch (shown) {
    case kExplodes:
    case kTooFast:
    case kEnergyGained:
    case kJointJitters:
    case kAnchorError:
    case kStepSensitive:
    case kSeedSensitive:
    case kSolverDiffers:
    case kEnginesDiffer:
    case kEngineRefused:
      return {kCauseMeshScale, kCauseStartOutsideLimits, kCauseDefaultInertia, kCauseInertia,
              kCauseMassRatio, kCauseWheelOffCenter,     kCauseMeshWheel,      kCauseNoCollision};
    // What a joint cannot hold moves.
    case kNeverSettles:
    case kRestless:
      return {
          kCauseMeshScale,  kCauseStartOutsideLimits, kCauseEffort,         kCauseDefaultInertia,
          kCauseInertia,    kCauseMassRatio,          kCauseWheelOffCenter, kCauseMeshWheel,
          kCauseNoCollision};
    case kCreeps:
      return {kCauseMeshScale, kCauseMeshWheel, kCauseWheelAxis, kCauseDefaultInertia,
              kCauseInertia};
    case kTips:
    case kNearlyTips:
    case kTiltsEarly:
    case kPushedOver:
      return {kCauseMeshScale,      kCauseTopHeavy,    kCauseWheelOffCenter, kCauseWheelAxis,
              kCauseDefaultInertia, kCauseNoCollision, kCauseInertia};
    case kSpawnedAbove: return {kCauseFlag};
    case kUnbalanced:
    case kFalls:
    case kSinks:
      return {kCauseMeshScale, kCauseNoCollision, kCauseFlag,           kCauseSoftContact,
              kCauseEffort,    kCauseMassRatio,   kCauseDefaultInertia, kCauseInertia};
    case kLimitViolated:
      return {kCauseStartOutsideLimits, kCauseMassRatio, kCauseDefaultInertia, kCauseInertia};
    case kStiffControl: return {kCauseInertia, kCauseDefaultInertia};
    case kDriveBackwards:
      return {kCauseFlag,    kCauseWheelFriction, kCauseWheelAxis, kCauseDefaultInertia,
              kCauseInertia, kCauseTopHeavy,      kCauseEffort,    kCauseNoCollision};
    case kDriveSlips:
      return {kCauseFlag,           kCauseWheelFriction, kCauseMeshWheel,
              kCauseWheelOffCenter, kCauseWheelAxis,     kCauseWheelRadii,
              kCauseDefaultInertia, kCauseInertia,       kCauseEffort};
    case kDriveDrifts:
      return {kCauseWheelFriction,  kCauseWheelOffCenter, kCauseWheelAxis,      kCauseWheelRadii,
              kCauseCasterFriction, kCauseMeshWheel,      kCauseDefaultInertia, kCauseInertia};
    case kDriveBounces:
      return {kCauseWheelOffCenter, kCauseMeshWheel, kCauseWheelAxis, kCauseDefaultInertia,
              kCauseInertia};
    case kTurnOff:
      return {kCauseFlag,      kCauseWheelFriction,  kCauseCasterFriction, kCauseWheelAxis,
              kCauseMeshWheel, kCauseWheelOffCenter, kCauseDefaultInertia, kCauseInertia};
    case kDoesNotBrake:
      return {kCauseWheelFriction, kCauseDefaultInertia, kCauseInertia, kCauseEffort};
    case kJointShort:
      return {kCauseStartOutsideLimits, kCauseEffort, kCauseDefaultInertia, kCauseInertia};
    case kJointOverloaded:
    case kDoesNotHold:
      return {kCauseEffort, kCauseStartOutsideLimits, kCauseDefaultInertia, kCauseInertia};
    default: return {};
  }
}

/// What is true of a link without an `<inertial>` is so of one with a mass alone.
bool is_kind(const Fact& cause, FactKind kind) {
  const bool is_default = cause.kind == FactKind::kCauseInertiaNotWritten;
  return (is_default ? FactKind::kCauseDefaultInertia : cause.kind) == kind;
}

}  // namespace

void Causes::add(FactKind kind, Fact about, double value, double limit, double weight,
                 double severe_from) {
  about.kind = kind;
  about.value = value;
  about.limit = limit;
  about.severe = weight >= severe_from;
  all.push_back({std::move(about), weight});
}

void add_joint_causes(Causes& causes) {
  const Scene& scene = causes.scene;
  const JointLoads loads(scene);
  std::vector<bool> stands;
  for (std::uint32_t m = 0; m < scene.models.size(); ++m) {
    const bool is_free = scene.alone && stands_free(scene, m);
    stands.push_back(is_free && stands_by_itself(scene, m) &&
                     !is_to_be_bolted(scene, m, causes.wheels));
  }
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) {
    const SceneJoint& joint = scene.joints[j];
    if (joint.axes.size() != 1 || joint.child >= scene.bodies.size()) continue;
    const SceneAxis& axis = joint.axes[0];
    Fact about = about_joint(scene, j);
    about.where = axis.limit_where.nowhere() ? about.where : axis.limit_where;
    const double outside = std::max(axis.lower - axis.start, axis.start - axis.upper);
    if (outside > kOutsideLimits) {
      causes.add(FactKind::kCauseStartOutsideLimits, about, outside, kOutsideLimits,
                 outside / kOutsideLimits, 1);
    }
    if (!can_be_commanded(joint) || !(axis.effort > 0) || !std::isfinite(axis.effort)) continue;
    // What lies on the ground with its links bears no more than what is between them.
    const bool lies = joint.model < scene.models.size() && stands[joint.model];
    const double weight =
        lies ? std::min(loads.weight(joint), loads.standing(joint)) : loads.weight(joint);
    const double load = std::max(weight, axis.friction);
    if (load > axis.effort) {
      causes.add(FactKind::kCauseEffort, about, load, axis.effort, load / axis.effort, 1);
    }
  }
}

Facts causes_in(const Scene& scene, const SceneInput& input, const DriveTrain& wheels) {
  Causes causes{scene, input, wheels, {}};
  add_inertia_causes(causes);
  add_mass_ratio_causes(causes);
  add_wheel_causes(causes);
  add_stance_causes(causes);
  add_joint_causes(causes);
  std::stable_sort(causes.all.begin(), causes.all.end(),
                   [](const auto& a, const auto& b) { return a.weight > b.weight; });
  Facts facts;
  for (Causes::Weighed& one : causes.all) facts.push_back(std::move(one.fact));
  return facts;
}

Facts explain(const Fact& shown, const Facts& causes) {
  Facts likely;
  if (hangs_on_contacts(shown.kind)) {
    std::copy_if(causes.begin(), causes.end(), std::back_inserter(likely),
                 [](const Fact& cause) { return cause.kind == FactKind::kCauseMeshMissing; });
    // With half of its shapes the rest is guesswork.
    if (!likely.empty()) return likely;
  }
  // What is in the joint's way is told.
  if (shown.kind == FactKind::kJointShort && !shown.help.empty()) return likely;
  for (const FactKind kind : kinds_behind(shown.kind)) {
    for (const Fact& cause : causes) {
      if (is_kind(cause, kind) && likely.size() < kMaxCauses) likely.push_back(cause);
    }
  }
  return likely;
}

}  // namespace rigor::simulate
