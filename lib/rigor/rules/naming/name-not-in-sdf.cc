// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/sdformat_robot.h>

namespace rigor::rules::name_not_in_sdf {

bool reserved(std::string_view name) {
  return name == "world" || (name.size() >= 4 && name.starts_with("__") && name.ends_with("__"));
}

template <class Entity>
void report_reserved(const Entity& entity, Context& context) {
  const std::string& name = entity.name.value;
  if (!reserved(name)) return;
  context.report({.where = entity.name.span,
                  .message = "'" + name + "' is a reserved name in SDF",
                  .subject = context.subject(entity)});
}

void check(const model::Model& robot, Context& context) {
  report_reserved(robot, context);
  const SdformatRobot& left = context.sdformat_robot();
  for (std::size_t i = 0; i < left.parts.size(); ++i) {
    if (left.parts[i].fate != SdformatRobot::Fate::kLink) continue;
    report_reserved(context.root()[robot.links[i]], context);
  }
  for (const SdformatRobot::Part& part : left.parts) {
    if (part.fate != SdformatRobot::Fate::kLink || !part.joint) continue;
    report_reserved(context.root()[part.joint], context);
  }
}

Rule rule() {
  return {
      .name = "name-not-in-sdf",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .targets = {Target::kGazeboClassic, Target::kGzSim},
      .summary = "a name of a URDF is reserved in SDF",
      .why = "Gazebo reads URDF through libsdformat. In SDF 'world' and names between double "
             "underscores are reserved: libsdformat rejects what it made of the robot (error 3). "
             "Names of links and joints that it drops or lumps together do not count.",
      .what_to_do = "Rename the link or joint.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::name_not_in_sdf
