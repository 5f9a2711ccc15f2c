// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// With which arguments a template is to be expanded, so that all of it is examined.
//
//   const ArgumentPlan plan = all_arguments(expansion, sources, disk, {});
//   for (const TemplateArguments& set : plan.sets) expand(path, set);

#pragma once

#include <string>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::read {

/// Sets for a template at most. Arms with 12 kinds, each with 3 grippers, have 15 values.
inline constexpr std::size_t kMaxArgumentSets = 48;

struct ArgumentPlan {
  std::vector<TemplateArguments> sets;
  std::string left_out;  ///< what the bound left out, in words; empty when nothing
};

/// The sets of `plan`, and for every value of an argument a set in which it has that value and the others
/// their defaults. Values are those that a condition compares the argument with; true and false, where the
/// argument is a condition itself; and where it is part of a path, as in `config/$(arg model)/limits.yaml`,
/// the entries of that folder that have such a file. A property or a macro's parameter that is given an argument
/// as it is counts as that argument. Values that would be more sets than the bound are
/// paired: a set then has a value of each argument.
ArgumentPlan all_arguments(const xacro::Expansion& expansion, const Sources& sources,
                           const Disk& disk, ArgumentPlan plan);

/// "gripper:=robotiq sim:=true"
std::string shown_arguments(const TemplateArguments& arguments);

}  // namespace rigor::read
