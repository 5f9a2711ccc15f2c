// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>

namespace rigor::rules::name_reserved {

constexpr int kFirstVersionWithNesting = 8;

std::string reason(std::string_view name, int version) {
  const bool underscores = name.size() >= 4 && name.starts_with("__") && name.ends_with("__");
  if (name == "world" || underscores) return "'" + std::string(name) + "' is a reserved name";
  const bool nested = name.find("::") != std::string_view::npos;
  if (!nested || version < kFirstVersionWithNesting) return {};
  return "'" + std::string(name) + "' holds '::', which separates the names of nested models";
}

template <class Entity>
void check(const Entity& entity, Context& context) {
  std::string message = reason(entity.name.value, context.root().version);
  if (message.empty()) return;
  context.report({.where = entity.name.span,
                  .message = std::move(message),
                  .subject = context.subject(entity)});
}

/// A model's name may come from elsewhere: then its own file's version decides, and its own check.
void check_model(const model::Model& model, Context& context) {
  if (context.root().own(model.site) && model.name.span.source == context.root().source) {
    check(model, context);
  }
}

Rule rule() {
  return {
      .name = "name-reserved",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "a name is reserved by the format",
      .why = "libsdformat refuses the file. 'world', and names that begin and end with two "
             "underscores, stand for frames that are always there; '::' separates the names of "
             "nested models, from SDF 1.8 on.",
      .what_to_do = "Choose another name.",
      .checks = {on<model::World>(check), on<model::Model>(check_model), on<model::Link>(check),
                 on<model::Joint>(check), on<model::Frame>(check), on<model::Collision>(check),
                 on<model::Visual>(check), on<model::Sensor>(check), on<model::Light>(check)},
  };
}

}  // namespace rigor::rules::name_reserved
