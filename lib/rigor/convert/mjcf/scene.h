// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `scene.xml`: ground, light and camera distance around a robot's file. Private to the room.

#pragma once

#include <string>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/robot/robot.h>

namespace rigor::convert {

/// Includes `file`.xml.
SideFile mjcf_scene(const robot::Robot& robot, const std::string& model, const std::string& file);

}  // namespace rigor::convert
