// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/rules/rule.h>

namespace rigor::rules::name_nonportable {

/// What breaks more than one program; '.', '-' and '+' are left alone.
bool is_trouble(char c) {
  return c == ' ' || c == '/' || c == '\\' || c == ':' || c == '"' || c == '\'' || c == '#';
}

template <class Entity>
void check(const Entity& entity, Context& context) {
  const std::string& name = entity.name.value;
  if (entity.name.span.source != context.root().source) return;
  if (name.find("::") != std::string::npos) return;  // an old way to nest: name-reserved
  const auto found = std::find_if(name.begin(), name.end(), is_trouble);
  if (found == name.end()) return;
  context.report({.where = entity.name.span,
                  .message = std::string("the name '") + name + "' holds " +
                             (*found == ' ' ? "a space" : "'" + std::string(1, *found) + "'"),
                  .subject = context.subject(entity)});
}

Rule rule() {
  return {
      .name = "name-nonportable",
      .severity = Severity::kInfo,
      .summary = "a name has characters that other programs cannot take",
      .why = "ROS takes no space in the name of a frame or topic made "
             "from it, and '/' and ':' separate names there; USD takes letters, digits and "
             "underscores only.",
      .what_to_do = "Write letters, digits and underscores.",
      .checks = {on<model::Link>(check), on<model::Joint>(check), on<model::Frame>(check),
                 on<model::Sensor>(check)},
  };
}

}  // namespace rigor::rules::name_nonportable
