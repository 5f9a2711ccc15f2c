// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::state_model_missing {

using Names = std::set<std::string_view>;

/// What the world has under a name; nothing when an include might have brought any.
std::optional<Names> names_in(const model::World& world, const model::Root& root) {
  Names names(world.names.begin(), world.names.end());
  for (const auto id : world.models) names.insert(root[id].name.value);
  for (const model::Include& include : root.includes) {
    if (include.name.written) names.insert(include.name.value);
    if (!include.loaded && !include.name.written) return std::nullopt;
  }
  return names;
}

void check(const model::World& world, Context& context) {
  if (world.states.empty()) return;
  const std::optional<Names> names = names_in(world, context.root());
  if (!names) return;
  for (const model::WorldState& state : world.states) {
    if (state.inserts) return;
    for (const model::ModelState& of : state.models) {
      if (!of.name.written || names->contains(of.name.value)) continue;
      const auto removed = xml::remove_element(context.document(), context.element(of.site));
      context.report({.where = of.name.span,
                      .message = "the state is of a model '" + of.name.value +
                                 "' that the world does not have",
                      .subject = context.subject(world),
                      .fix = fix_of("remove it", Applicability::kUnsafe, removed)});
    }
  }
}

Rule rule() {
  return {
      .name = "state-model-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the <state> of a world names a model that is not in it",
      .why = "The state of a model that was renamed or removed has no effect, and the renamed one "
             "begins elsewhere than it was saved. Gazebo classic writes the places of all models "
             "into <state> when it saves a world, and puts them there when it loads it.",
      .what_to_do = "Give the state the model's new name, or remove it.",
      .checks = {on<model::World>(check)},
  };
}

}  // namespace rigor::rules::state_model_missing
