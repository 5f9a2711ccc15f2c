// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::physics_several_defaults {

void check(const model::Physics& physics, Context& context) {
  if (!physics.is_default.value || !physics.world) return;
  for (const model::Physics& other : context.root().physics) {
    if (&other == &physics) return;  // this is the first
    if (other.world != physics.world || !other.is_default.value) continue;
    context.report({.where = physics.is_default.span,
                    .message = "a second <physics> is the default: the first one, '" +
                               other.name.value + "', counts",
                    .related = {{other.is_default.span, "the first"}},
                    .fix = fix_of("keep the first as the default", Applicability::kUnsafe,
                                  attribute_removed(context, physics.site, "default"))});
    return;
  }
}

Rule rule() {
  return {
      .name = "physics-several-defaults",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "more than one <physics> of a world is the default",
      .why = "libsdformat uses the first one that is marked; the others have no effect. A world "
             "may describe several engines and steps, and the default one is used.",
      .what_to_do = "Leave default=\"true\" with the one that is meant.",
      .checks = {on<model::Physics>(check)},
  };
}

}  // namespace rigor::rules::physics_several_defaults
