// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests of a robot with wheels: drive, turn, brake. Commands rise over a second: told its full speed at
// once, a robot loses some per cent of its way to wheels that spin (docs/simulate.md).

#include <rigor/simulate/test/parts.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <rigor/simulate/round_shape.h>

namespace rigor::simulate {
namespace {

constexpr double kRamp = 1;        // s
constexpr double kCruise = 3;      // s, at full speed
constexpr double kTurnCruise = 2;  // s
constexpr double kHalt = 0.5;      // s, from full speed to none

constexpr double kParallel = 0.98;  // cosine: axes of the wheels of one robot

std::string no_wheels(const DriveTrain& wheels) {
  if (wheels.named) {
    return "none of the joints named as wheels is a hinge with a level axis and a round collision";
  }
  return "no wheels found: there is no hinge without limits whose axis is level and that carries a "
         "round collision which reaches the ground";
}

/// "right_wheel": the joint's own name.
std::string_view own_name(std::string_view scoped) {
  const std::size_t at = scoped.rfind("::");
  return at == std::string_view::npos ? scoped : scoped.substr(at + 2);
}

/// A round link on an axis like the wheels', whose joint has limits, which no wheel has; null where there is none.
const SceneJoint* limited_wheel(const Scene& scene, const DriveTrain& wheels) {
  const Vector3& axis =
      scene.joints[wheels.left.empty() ? wheels.right.front().joint : wheels.left.front().joint]
          .axes[0]
          .direction_W;
  for (const SceneJoint& joint : scene.joints) {
    if (joint.type != model::JointType::kRevolute || joint.model != wheels.model) continue;
    if (can_turn_over(joint) || std::abs(dot(joint.axes[0].direction_W, axis)) < kParallel)
      continue;
    const auto rolls = [&](const SceneShape& shape) {
      return shape.body == joint.child && round_about(scene, shape, joint.axes[0].direction_W);
    };
    if (std::any_of(scene.shapes.begin(), scene.shapes.end(), rolls)) return &joint;
  }
  return nullptr;
}

/// Why the wheels that were found are all on one side.
std::string one_sided(const Scene& scene, const DriveTrain& wheels) {
  const std::string found = "all of its wheels are on one side";
  const SceneJoint* limited = limited_wheel(scene, wheels);
  if (limited == nullptr) return found;
  return found + "; joint '" + std::string(own_name(limited->name)) +
         "' has limits, so it is not taken for one (`--wheels` names them)";
}

/// Why it does not drive straight ahead: a wheel is missing.
std::string why_not_ahead(const Scene& scene, const DriveTrain& wheels) {
  if (wheels.empty()) return no_wheels(wheels);
  const bool lacks_one =
      !wheels.steers() && wheels.steering.empty() && limited_wheel(scene, wheels);
  return lacks_one ? one_sided(scene, wheels) : std::string();
}

Scenario settled_first(std::string name, const Scene& scene) {
  const double settled = settling_time(scene);
  Scenario scenario{.name = std::move(name), .spawn = Spawn::kOnGround};
  scenario.phases = {{"settle", 0, settled}, rest_of(0, settled)};
  return scenario;
}

/// As a robot's controller does, which knows one radius: a positive velocity is to roll each wheel
/// forward, the same for all of an axle. A side that is reversed, or smaller, then shows.
DriveTrain as_told(const DriveTrain& wheels) {
  DriveTrain told = wheels;
  for (auto* side : {&told.left, &told.right}) {
    for (Wheel& wheel : *side) {
      wheel.sign = 1;
      for (const auto* other_side : {&wheels.left, &wheels.right}) {
        for (const Wheel& other : *other_side) {
          const double ahead = dot(other.center_W - wheel.center_W, wheels.forward_W);
          if (std::abs(ahead) > kAxleShare * other.radius) continue;
          wheel.radius = std::max(wheel.radius, other.radius);
        }
      }
    }
  }
  return told;
}

}  // namespace

MadeTest make_drive(const Scene& scene, const DriveTrain& wheels) {
  if (const std::string why = why_not_ahead(scene, wheels); !why.empty()) return {{}, why};
  Scenario scenario = settled_first("drive", scene);
  const double settled = scenario.phases.front().end;
  const double cruise = settled + kRamp;
  const Phase drive{"drive", settled, cruise + kCruise};
  scenario.duration = drive.end;
  scenario.phases.push_back(drive);
  scenario.phases.push_back({"cruise", cruise, drive.end});
  add_brakes(scene, wheels, scenario);
  const double speed = drive_speed(scene, wheels);
  add_drive(as_told(wheels), speed, speed, drive, kRamp, scenario);
  return {std::move(scenario), {}};
}

// An arc first, since a spin alone does not show a caster that grips; then a spin.
MadeTest make_turn(const Scene& scene, const DriveTrain& wheels) {
  if (wheels.empty()) return {{}, no_wheels(wheels)};
  if (!wheels.steering.empty())
    return {{}, "it steers by turning wheels, not by its sides' speeds"};
  if (!wheels.steers()) return {{}, one_sided(scene, wheels)};
  Scenario scenario = settled_first("turn", scene);
  const double settled = scenario.phases.front().end;
  const Phase arc{"arc", settled, settled + kRamp + kTurnCruise};
  const Phase halt{"halt", arc.end, arc.end + 2 * kHalt};
  const Phase spin{"spin", halt.end, halt.end + kRamp + kTurnCruise};
  scenario.duration = spin.end;
  scenario.phases.insert(scenario.phases.end(), {arc, halt, spin});
  add_brakes(scene, wheels, scenario);
  const double speed = drive_speed(scene, wheels);
  add_drive(wheels, speed / 2, speed, arc, kRamp, scenario);
  add_drive(wheels, 0, 0, halt, kHalt, scenario);
  add_drive(wheels, -speed / 2, speed / 2, spin, kRamp, scenario);
  return {std::move(scenario), {}};
}

MadeTest make_brake(const Scene& scene, const DriveTrain& wheels) {
  if (const std::string why = why_not_ahead(scene, wheels); !why.empty()) return {{}, why};
  Scenario scenario = settled_first("brake", scene);
  const double settled = scenario.phases.front().end;
  const Phase run_up{"run-up", settled, settled + kRamp + 1};
  const Phase brake{"brake", run_up.end, run_up.end + kHalt + 1};
  scenario.duration = brake.end;
  scenario.phases.insert(scenario.phases.end(), {run_up, brake});
  add_brakes(scene, wheels, scenario);
  const double speed = drive_speed(scene, wheels);
  add_drive(wheels, speed, speed, run_up, kRamp, scenario);
  add_drive(wheels, 0, 0, brake, kHalt, scenario);
  return {std::move(scenario), {}};
}

}  // namespace rigor::simulate
