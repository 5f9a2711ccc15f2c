// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/core.h>

#include <rigor/rules/inertia/joint_masses.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mass_ratio_across_joint {

// Propellers and steering wheels have a hundredth of what they are on; the rest is tokens.
constexpr double kMax = 1000;

// Double precision itself is spent on such a ratio when a solver squares it.
constexpr double kGrave = 1e6;

void check(const model::Root& root, Context& context) {
  for (const JointMasses& masses : joint_masses(context)) {
    const model::Joint& joint = root[masses.joint];
    if (masses.parent == kImmovable || masses.child == kImmovable || !root.own(joint.site))
      continue;
    const double heavy = std::max(masses.parent, masses.child);
    const double light = std::min(masses.parent, masses.child);
    if (!(heavy > kMax * light)) continue;
    const bool light_child = light == masses.child;
    const double ratio = heavy / light;
    context.report(
        {.where = joint.site.name,
         .message = fmt::format(
             "the joint's {} has {:.4g} kg, its {} {:.4g} kg: {} times as much",
             light_child ? "child" : "parent", light, light_child ? "parent" : "child", heavy,
             ratio < 1e7 ? fmt::format("{:.0f}", ratio) : fmt::format("{:.3g}", ratio)),
         .subject = context.subject(joint),
         .severity = ratio < kGrave ? Severity::kInfo : Severity::kWarning});
  }
}

Rule rule() {
  return {
      .name = "mass-ratio-across-joint",
      .severity = Severity::kInfo,
      .summary = "large mass ratio across a joint",
      .why = "Iterative solvers, which Gazebo's engines use by default, need about as many "
             "iterations as the ratio of the masses: a token mass on a real robot costs accuracy. "
             "A light body at the end of a chain mostly does no harm; one between heavy bodies "
             "does (light-link-between-heavy). From a ratio of 10⁶ on it is a warning.",
      .what_to_do = "Make the light body heavier, or fix it to its neighbor. Masses within a "
                    "factor of 50 are safe.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mass_ratio_across_joint
