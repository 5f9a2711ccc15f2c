// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a file calls its robot, without reading it: how a robot is found by its name.
//
//   if (robot_name_in(bytes) == srdf.robot.text) load(path);

#pragma once

#include <string>
#include <string_view>

namespace rigor::read {

/// The `name` of a file's root `<robot>`, derived from its first bytes; empty where there is none, or an expression
/// makes it.
std::string robot_name_in(std::string_view bytes);

}  // namespace rigor::read
