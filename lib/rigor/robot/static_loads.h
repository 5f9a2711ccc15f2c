// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What gravity asks of joints that hold a robot still: inverse dynamics of its tree at rest, without
// friction and springs.
//
//   const Efforts efforts = holding_efforts(robot, positions, {0, 0, -9.8});
//   const StaticLoads loads = static_loads(robot, {.samples = 1000});
//   for (const AxisLoad& axis : loads.axes) print(axis.effort, axis.limit);
//
// An axis turns or shifts the bodies behind it, of mass m with the center of mass at r. To hold them
// takes −Σ n·((r − p) × m g) about an axis n through p, and −Σ n·m g along it; along a screw the sum of
// both, the second times its pitch. Joints that close a loop take no load here: of a robot with loops
// the efforts are those of the tree that is left.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/robot/robot.h>

namespace rigor::robot {

/// By joint and axis, N·m, or N of a sliding axis; positive along the axis.
using Efforts = std::vector<std::vector<double>>;

/// `gravity_M` in m/s², in the frame of the model. An axis that follows another takes none itself: its load
/// is added to its leader's, times the multiplier.
Efforts holding_efforts(const Robot& robot, const Positions& positions,
                        const model::Vector3& gravity_M);

struct LoadRequest {
  model::Vector3 gravity_M{0, 0, -9.8};  ///< m/s²; libsdformat's default
  std::size_t samples = 1000;
  std::uint64_t seed = 1;  ///< the same one gives the same samples everywhere
};

/// The largest load of an axis.
struct AxisLoad {
  std::uint32_t joint = 0;
  std::uint32_t axis = 0;
  double effort = 0;  ///< N·m or N, with its sign
  double limit = 0;   ///< of the same unit; infinity where there is none
  Positions at;       ///< where it is that large
};

/// A box in the frame of the model, m.
struct Reach {
  model::Vector3 min;
  model::Vector3 max;
};

struct StaticLoads {
  std::vector<AxisLoad> axes;  ///< of all joints that move and follow none
  std::optional<Reach> reach;  ///< of the bodies' origins and centers of mass; none without bodies
  bool has_loops = false;      ///< the tree alone was computed
};

/// Over positions drawn uniformly within the limits (a hinge without any: ±π; a sliding axis without
/// any stays at zero), zero first. From the worst one each axis' load is raised further, one joint at a
/// time: it is a + b cos q + c sin q of a hinge and a + b q of a sliding axis, so that its maximum within
/// the limits is exact. Robots of over 100 joints get samples alone.
StaticLoads static_loads(const Robot& robot, const LoadRequest& request);

}  // namespace rigor::robot
