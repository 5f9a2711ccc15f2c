// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>
#include <unordered_set>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::inertia_singular {

/// A point of mass that is fixed to another link of a URDF becomes part of that.
std::unordered_set<std::string_view> fixed_links(const model::Root& root) {
  std::unordered_set<std::string_view> names;
  for (const model::Joint& joint : root.joints) {
    if (joint.type == model::JointType::kFixed) names.insert(joint.child.value);
  }
  return names;
}

void check(const model::Root& root, Context& context) {
  const auto fixed = context.is_urdf() ? fixed_links(root) : std::unordered_set<std::string_view>();
  for (const model::Link& link : root.links) {
    const double mass = link.inertial.mass.value;
    if (!root.own(link.site) || !has_tensor(link, context) || !(mass > 0)) continue;
    if (!is_dynamic(link, context) || fixed.count(link.name.value) != 0) continue;
    const mass::Verdict& verdict = context.verdict(link);
    if (!verdict.possible() || verdict.smallest != mass::Verdict::Sign::kZero) continue;
    const bool all = verdict.principal[2] == 0;
    context.report({.where = link.inertial.tensor_site.name,
                    .message = fmt::format("a body of {} kg has no moment of inertia about {} axis",
                                           mass, all ? "any" : "one"),
                    .subject = context.subject(link),
                    .fix = fix_from_shapes(link, context)});
  }
}

Rule rule() {
  return {
      .name = "inertia-singular",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a body that moves has no moment of inertia about an axis",
      .why = "libsdformat and urdfdom take a point or a thin rod, but an engine has to divide by "
             "the moment: ODE stops at an assertion, KDL and MuJoCo refuse, others set a number of "
             "their own.",
      .what_to_do = "Write the moments of the real body: even a pin has some, about every axis.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::inertia_singular
