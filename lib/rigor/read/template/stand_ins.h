// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Arguments for a template that makes no robot by itself, as one whose `name` is used before it has a default, or
// whose `ur_type` has a default that is no model's: launch files give these.
//
//   const auto arguments = stand_ins(expansion, others, sources, disk, makes_robot);

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::read {

/// Sets of arguments that are tried, of each kind.
inline constexpr std::size_t kMaxStandIns = 12;

/// Whether an argument was used that has no value.
bool lacks_argument(const xacro::Expansion& expansion);

/// The defaults of the arguments that the expansion lacks, and the first values of others with which `makes_robot`
/// says there is a robot; it is asked with a number, from 0, and the arguments. An argument without any default is
/// given its own name, where it is only part of the robot's, and the others what robots in `others` give to the same macros.
/// Nothing where the expansion lacks no argument, or no set makes a robot.
std::optional<TemplateArguments> stand_ins(
    const xacro::Expansion& expansion, const std::vector<const xacro::Expansion*>& others,
    const Sources& sources, const Disk& disk,
    const std::function<bool(std::size_t number, const TemplateArguments& arguments)>& makes_robot);

}  // namespace rigor::read
