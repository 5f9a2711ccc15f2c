// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of tests.h are put together from. For sources of this room.
//
//   scenario.phases = {{"settle", 0, 1}, rest_of(0, 1)};
//   add_brakes(scene, wheels, scenario);

#pragma once

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene.h>
#include <rigor/simulate/tests.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// s: a robot that is set on the ground is at rest well within this. One on springs takes longer.
double settling_time(const Scene& scene);

/// The last fifth of a span, in which all should be at rest.
Phase rest_of(double begin, double end);

/// What stands still in a robot that is switched on is held by its motors: every hinge and slider that
/// is not a wheel, a caster, a spring or a mimic is told to stand still for the whole scenario.
void add_brakes(const Scene& scene, const DriveTrain& wheels, Scenario& scenario);

bool is_wheel_joint(const DriveTrain& wheels, std::uint32_t joint);

/// Whether such a command can be given: a hinge or a slider that follows no other joint.
bool can_be_told(const SceneJoint& joint);

/// m/s, at the rim: brisk, but not so that a robot of this size tips when it gets there in a second.
double drive_speed(const Scene& scene, const DriveTrain& wheels);

/// Commands to all wheels of a side to roll at `speed` (m/s) forward, from `begin` to `end`.
void add_drive(const DriveTrain& wheels, double left, double right, const Phase& when, double ramp,
               Scenario& scenario);

/// kg·m², of all that hangs on a hinge (of a slider: kg), about its axis.
double carried_inertia(const Scene& scene, const SceneJoint& joint);

/// kg·m² (of a slider kg): what an effort between the joint's two bodies moves when everything else
/// gives way: the two inertias in series.
double effective_inertia(const Scene& scene, const SceneJoint& joint);

/// N·m (of a slider N): what gravity asks of the joint at the start.
double carried_load(const Scene& scene, const SceneJoint& joint);

/// How a sweep moves a joint.
struct SweepMotion {
  double least = 0;  ///< rad, m
  double most = 0;
  double speed = 0;         ///< rad/s, m/s
  double acceleration = 0;  ///< rad/s², m/s², as it starts and stops
};

/// N·m (of a slider N): the most that a motor has to give for it, with all else held as at the start:
/// against gravity, to start and stop, against friction and damping.
double sweep_effort(const Scene& scene, const SceneJoint& joint, const SweepMotion& motion);

MadeTest make_settle(const Scene& scene, const DriveTrain& wheels);
MadeTest make_drop(const Scene& scene, const DriveTrain& wheels);
MadeTest make_push(const Scene& scene, const DriveTrain& wheels);
MadeTest make_tilt_table(const Scene& scene, const DriveTrain& wheels);
MadeTest make_drive(const Scene& scene, const DriveTrain& wheels);
MadeTest make_turn(const Scene& scene, const DriveTrain& wheels);
MadeTest make_brake(const Scene& scene, const DriveTrain& wheels);
MadeTest make_joint_sweep(const Scene& scene, const DriveTrain& wheels);
MadeTest make_hold(const Scene& scene, const DriveTrain& wheels);

}  // namespace rigor::simulate
