// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::plane_on_moving_link {

/// The model that would have to be static: its own, when nothing in it can move.
std::optional<Fix> make_static(const model::Model& model, Context& context) {
  // One that is there, if only misspelt, has to be put right first.
  if (!context.root().own(model.site) || !model.joints.empty() || model.links.size() != 1 ||
      model.is_static.written || has_near_child(model.site, "static", context)) {
    return std::nullopt;
  }
  return fix_of("make the model static", Applicability::kUnsafe,
                inserted(context, model.site, {}, "<static>true</static>"));
}

void check(const model::Collision& collision, Context& context) {
  if (!std::holds_alternative<model::Plane>(collision.geometry.shape)) return;
  const model::Root& root = context.root();
  const model::Link& link = root[collision.link];
  if (!link.model || link.kinematic.value || is_static(root, link.model)) return;
  context.report(
      {.where = collision.geometry.site.name,
       .message =
           "the link '" + link.name.value +
           "' moves, but has a plane as collision: ODE and MuJoCo take a plane only on what stays",
       .subject = context.subject(collision),
       .fix = make_static(root[link.model], context)});
}

Rule rule() {
  return {
      .name = "plane-on-moving-link",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a plane collides on a link that moves",
      .why = "ODE knows no plane that moves with a body, MuJoCo rejects one, and a ground that is "
             "not static falls. A plane is a half space: all below it is solid.",
      .what_to_do =
          "Add <static>true</static> to the model when it is the ground, else use a thin box.",
      .checks = {on<model::Collision>(check)},
  };
}

}  // namespace rigor::rules::plane_on_moving_link
