// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a robot is driven: transmissions and plugins of Gazebo classic in the words of Gazebo Sim, or of
// ros2_control. Private to the room.
//
//   if (is_control(draft.options.control, plugin)) …  // not carried as it is
//   add_control(draft, files);

#pragma once

#include <vector>

#include <rigor/convert/sdf/draft.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

/// Whether a plugin of the robot is one that `add_control` writes anew.
bool is_control(ControlPolicy policy, xml::Element plugin);

/// Takes the transmissions and the plugins that `is_control` names; their joints get plugins of Gazebo
/// Sim, or one of gz_ros2_control with two files beside the result: the `<ros2_control>` block for the
/// robot description, and the controllers that it starts.
void add_control(SdfDraft& draft, std::vector<SideFile>& files);

}  // namespace rigor::convert
