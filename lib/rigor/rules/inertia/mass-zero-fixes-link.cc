// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mass_zero_fixes_link {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.mass.written || inertial.mass.value != 0 || !is_dynamic(link, context)) return;
  context.report(
      {.where = inertial.mass.span,
       .message = "the mass is 0 kg: Bullet fixes the link '" + link.name.value + "' in place",
       .subject = context.subject(link)});
}

Rule rule() {
  return {
      .name = "mass-zero-fixes-link",
      .severity = Severity::kInfo,
      .formats = Formats::kUrdf,
      .targets = {Target::kBullet},
      .summary = "Bullet fixes a link of mass zero in place",
      .why = "In Bullet a body of mass 0 is static: it does not fall, and nothing pushes it. That "
             "is how a plane or a table is made, and not what a robot's link should do. A link "
             "without <inertial> has 1 kg there.",
      .what_to_do = "Write the mass of a link that moves; leave 0 for what is fixed to the ground.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_zero_fixes_link
