// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>

namespace rigor::rules::name_empty {

/// Of a URDF libsdformat keeps no fixed joints: their links are one.
bool in_model(const model::Joint& joint) { return joint.type_name.value != "fixed"; }
template <class Other>
bool in_model(const Other&) {
  return true;
}

template <class Entity>
void check(const Entity& entity, Context& context) {
  const auto& name = entity.name;
  if (!name.written || !name.value.empty()) return;
  const std::string kind(context.bytes(entity.site.name));
  if (context.is_urdf() && (kind == "visual" || kind == "collision")) return;  // none is needed
  context.report({.where = entity.site.tag,
                  .message = "the name of this " + kind + " is empty",
                  .subject = context.subject(entity),
                  .refused = in_model(entity)});
}

Rule rule() {
  return {
      .name = "name-empty",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kSays},
      .summary = "a name is empty",
      .why =
          "libsdformat refuses the file. urdfdom takes it, and then nothing can refer to the part.",
      .what_to_do = "Give it a name.",
      .checks = {on<model::World>(check), on<model::Model>(check), on<model::Link>(check),
                 on<model::Joint>(check), on<model::Frame>(check), on<model::Collision>(check),
                 on<model::Visual>(check), on<model::Sensor>(check), on<model::Light>(check),
                 on<model::Plugin>(check)},
  };
}

}  // namespace rigor::rules::name_empty
