// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `scene.xml`: ground, light and camera distance around a robot's file. Private to the room.

#pragma once

#include <string>

#include <rigor/convert/mjcf/assembly.h>
#include <rigor/convert/sdf_to_urdf.h>

namespace rigor::convert {

/// Includes `file`.xml. There is no ground where a static model or a plane is one.
SideFile mjcf_scene(const MjcfAssembly& assembly, const std::string& model,
                    const std::string& file);

}  // namespace rigor::convert
