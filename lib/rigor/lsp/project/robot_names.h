// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a robot has that other files name: its links, its joints and their limits.
//
//   RobotNames robot = robot_names(analysis);
//   if (!robot.links.contains("palm")) complain();

#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>

#include <rigor/lsp/document/analysis.h>

namespace rigor::lsp {

struct JointRange {
  double lower = -std::numeric_limits<double>::infinity();  ///< rad or m
  double upper = std::numeric_limits<double>::infinity();
  bool moves = true;       ///< false of a fixed joint
  bool in_meters = false;  ///< of a prismatic joint; else an angle
};

struct RobotNames {
  std::set<std::string, std::less<>> links;
  std::map<std::string, JointRange, std::less<>> joints;
};

RobotNames robot_names(Analysis& analysis);

/// The `name` of a file's root `<robot>`, derived from its first bytes; empty where there is none, or an expression
/// makes it.
std::string robot_name_in(std::string_view bytes);

}  // namespace rigor::lsp
