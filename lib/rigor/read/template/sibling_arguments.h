// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What other robots give to the macros that a template calls. A general template such as `ur.xacro` takes the
// paths of its parameter files as arguments, empty unless a launch file gives them; `ur10.xacro` beside it calls
// the same macro with those of one robot.
//
//   for (const TemplateArguments& set : sibling_arguments(expansion, sources, others)) expand(path, set);

#pragma once

#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::read {

/// For the arguments that are empty, or have no default, and that the template hands to a parameter of a macro as
/// `parameter="$(arg name)"`: the values which that parameter has in the calls of the same macros in `others`. Each
/// set is of one call, has all of these arguments, and is there once.
std::vector<TemplateArguments> sibling_arguments(
    const xacro::Expansion& expansion, const Sources& sources,
    const std::vector<const xacro::Expansion*>& others);

}  // namespace rigor::read
