// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An MJCF model as SDF in the making. A link's frame is that of its body. Private to the room.

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <rigor/convert/from_mjcf/plan.h>
#include <rigor/convert/from_mjcf/shape.h>
#include <rigor/convert/sdf/draft.h>

namespace rigor::convert {

/// Sensors as text, by what carries them.
struct MjcfSensors {
  std::map<std::uint32_t, std::vector<std::string>> of_body;
  std::map<std::uint32_t, std::vector<std::string>> of_joint;  ///< of the plan's robot
};

/// An accelerometer and a gyro of one site are an imu, force and torque a force_torque sensor of the joint
/// that carries the body, a camera of a body a camera. Others are lost.
MjcfSensors mjcf_to_sdf_sensors(const MjcfPlan& plan, Ledger& ledger);

}  // namespace rigor::convert
