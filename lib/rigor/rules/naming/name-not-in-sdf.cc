// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
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
  std::map<std::string_view, const model::Link*> links;
  for (std::size_t i = 0; i < left.parts.size(); ++i) {
    if (left.parts[i].fate != SdformatRobot::Fate::kLink) continue;
    const model::Link& link = context.root()[robot.links[i]];
    links.emplace(link.name.value, &link);
    report_reserved(link, context);
  }
  for (const SdformatRobot::Part& part : left.parts) {
    if (part.fate != SdformatRobot::Fate::kLink || !part.joint) continue;
    const model::Joint& joint = context.root()[part.joint];
    report_reserved(joint, context);
    const auto same = links.find(joint.name.value);
    if (same == links.end()) continue;
    context.report({.where = joint.name.span,
                    .message = "the joint has the name of a link, which SDF does not allow",
                    .subject = context.subject(joint),
                    .related = {{same->second->name.span, "the link"}}});
  }
}

Rule rule() {
  return {
      .name = "name-not-in-sdf",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .targets = {Target::kGazeboClassic, Target::kGzSim},
      .summary = "a name of a URDF cannot stand in SDF",
      .why = "Gazebo reads URDF through libsdformat. In SDF a link and a joint of one model cannot "
             "share a name, and 'world' and names between double underscores are reserved: "
             "libsdformat refuses what it made of the robot (errors 2 and 3). Names of what it "
             "leaves out or lumps together do not count.",
      .what_to_do = "Rename the joint, as in elbow_joint.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::name_not_in_sdf
