// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <rigor/rules/rule.h>

namespace rigor::rules::model_without_link {

/// What stands in the place of links: nested models, and includes, which bring some when they are found.
bool has_parts(const model::Model& model, const Context& context) {
  const auto& includes = context.root().includes;
  const auto inside = [&](const model::Include& include) {
    return include.model && &context.root()[include.model] == &model;
  };
  return !model.links.empty() || !model.models.empty() || !model.merged_models.empty() ||
         std::any_of(includes.begin(), includes.end(), inside);
}

void check(const model::Model& model, Context& context) {
  if (model.is_static.value || model.merged || has_parts(model, context)) return;
  context.report({.where = model.site.name,
                  .message = "the model has no link: there is nothing that can move",
                  .subject = context.subject(model)});
}

Rule rule() {
  return {
      .name = "model-without-link",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "a model that is not static has no link",
      .why = "libsdformat refuses the file (error 16). Only a static model may be without links, "
             "to hold plugins or frames.",
      .what_to_do = "Give the model a link, or make it static.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::model_without_link
