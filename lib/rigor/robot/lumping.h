// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot as a conversion may choose to write it.

#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include <rigor/robot/robot.h>

namespace rigor::robot {

/// With mass, shapes and joints of each body of the map held by the one that it names, and a frame where
/// the body was. Only where nothing but fixed joints lies between the two; else it stays a body.
Robot with_embedded(const Robot& robot, const std::map<std::string, std::string>& held_by);

/// Seen from the world and not from its model: what hangs on the world stands where the model's pose puts
/// it, and every root is fixed there, by a joint without a name.
Robot in_world(Robot robot);

using PartNames = std::set<std::string, std::less<>>;

/// Takes away the bodies and the joints of these names, and joints that have lost an end.
void remove(Robot& robot, const PartNames& bodies, const PartNames& joints);

}  // namespace rigor::robot
