// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an expansion's elements came from, for people and for programs.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/workspace.h>
#include <rigor/robot/compare.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

#include "project/reach.h"

namespace rigor::tool {

/// "robot.xacro:88:3"; "?" for a span that is nowhere.
std::string shown_place(const Sources& sources, Span where);

/// Of differences between the models of two files, the places where their authors wrote what differs: of a template, in
/// it or in a file that it includes.
void place_in_source(std::vector<robot::Difference>& differences, const read::File& a,
                     const read::File& b, const Sources& sources);

/// What the fact says; of one in a file out of reach only that.
std::string described(const xacro::Fact& fact, const Sources& sources, const Reach& reach);

/// `in macro 'leg' (prefix='FL'), called at robot.xacro:88:3`, a line each, innermost first.
std::string shown_stack(const Sources& sources, const std::vector<xacro::FactFrame>& stack);

/// Of a path as `robot/link[base]/inertial/mass@value`, where `[…]` is a name or a 1-based number, what is
/// there and what brought it; nothing when there is no such element or attribute.
std::optional<std::string> trace(const xacro::Expansion& expansion, const Sources& sources,
                                 std::string_view path);

}  // namespace rigor::tool
