// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of tests.h are put together from. For sources of this room.
//
//   scenario.phases = {{"settle", 0, 1}, rest_of(0, 1)};
//   add_brakes(scene, wheels, scenario);

#pragma once

#include <cstdint>

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/test/tests.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// s: a robot that is set on the ground is at rest well within this. One on springs takes longer.
double settling_time(const Scene& scene);

/// The last fifth of a span, in which all should be at rest.
Phase rest_of(double begin, double end);

/// What stands still in a robot that is switched on is held by its motors: every hinge and slider that
/// is not a wheel, a caster, a spring or a mimic is commanded to stand still for the whole scenario.
void add_brakes(const Scene& scene, const DriveTrain& wheels, Scenario& scenario);

bool is_wheel_joint(const DriveTrain& wheels, std::uint32_t joint);

/// m/s, at the rim: brisk, but not so that a robot of this size tips when it gets there in a second.
double drive_speed(const Scene& scene, const DriveTrain& wheels);

/// Commands to all wheels of a side to roll at `speed` (m/s) forward, from `begin` to `end`.
void add_drive(const DriveTrain& wheels, double left, double right, const Phase& when, double ramp,
               Scenario& scenario);

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
