// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::automatic_inertia_overridden {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!is_computed(link, context)) return;
  std::vector<Edit> edits;
  std::string what;
  for (const model::Site& unused : {inertial.pose.site, inertial.tensor_site}) {
    if (unused.span.nowhere()) continue;
    what += (what.empty() ? "<" : " and <") + std::string(context.bytes(unused.name)) + ">";
    for (Edit& edit : removed(context, unused)) edits.push_back(edit);
  }
  if (what.empty()) return;
  context.report(
      {.where = inertial.automatic.span,
       .message = "mass and tensor are computed from the collisions: what is written as " + what +
                  " is not used",
       .subject = context.subject(link),
       .fix = fix_of("remove " + what, Applicability::kUnsafe, std::move(edits))});
}

Rule rule() {
  return {
      .name = "automatic-inertia-overridden",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "an automatic inertial has a pose or tensor that is not used",
      .why =
          "libsdformat 14 and later compute the tensor and the center of mass from the collisions, "
          "and warn that the written ones are overwritten. A written mass is used from 15.2 on. "
          "libsdformat 13 and older do the opposite: they do not know auto=\"true\".",
      .what_to_do = "Remove what is not used, or auto=\"true\".",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::automatic_inertia_overridden
