// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/rule.h>

#include <rigor/text/letter_case.h>

namespace rigor::rules::name_differs_by_case {

template <class Entity>
void check_kind(const std::vector<model::Id<Entity>>& ids, const char* kind, Context& context) {
  const model::Root& root = context.root();
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto has_upper = [&](model::Id<Entity> id) {
    const std::string& name = root[id].name.value;
    return std::any_of(name.begin(), name.end(), is_upper);
  };
  // Most models have none, and then no two can differ so.
  if (ids.size() < 2 || std::none_of(ids.begin(), ids.end(), has_upper)) return;
  std::unordered_map<std::string, model::Id<Entity>> first;
  for (const auto id : ids) {
    const model::Field<std::string>& name = root[id].name;
    const auto [known, is_new] = first.emplace(lowered(name.value), id);
    if (is_new || root[known->second].name.value == name.value || !root.own(root[id].site))
      continue;
    context.report({.where = name.span,
                    .message = fmt::format("the {}s '{}' and '{}' differ only by case", kind,
                                           root[known->second].name.value, name.value),
                    .subject = context.subject(root[id]),
                    .related = {{root[known->second].name.span, "the other one"}}});
  }
}

void check(const model::Model& model, Context& context) {
  check_kind(model.links, "link", context);
  check_kind(model.joints, "joint", context);
  check_kind(model.frames, "frame", context);
}

Rule rule() {
  return {
      .name = "name-differs-by-case",
      .severity = Severity::kWarning,
      .summary = "two names differ only by upper and lower case",
      .why = "SDF and URDF tell them apart, but people do not, and neither does whatever makes "
             "files of names where case does not count.",
      .what_to_do = "Give them names that are told apart at a glance, or the same name where one "
                    "thing is meant.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::name_differs_by_case
