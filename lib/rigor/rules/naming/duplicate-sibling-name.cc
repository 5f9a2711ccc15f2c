// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/rules/naming/named.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/sdformat_robot.h>
#include <rigor/schema/version.h>

namespace rigor::rules::duplicate_sibling_name {

/// Whether poses, joints and frames refer to things of the kind by name. The others have their names for
/// people and topics, and only the check of `ign sdf -k` compares them across kinds.
bool is_frame(std::string_view kind) {
  return kind == "link" || kind == "joint" || kind == "frame" || kind == "model" ||
         kind == "include" || kind == "world";
}

/// In older files libsdformat renames the later one while it loads, as Gazebo does.
constexpr int kFirstRejected = 7;

std::optional<Severity> severity_of(const Named& first, const Named& again,
                                    const Context& context) {
  if (!is_frame(first.kind) || !is_frame(again.kind)) return Severity::kInfo;
  if (context.root().version < kFirstRejected) return Severity::kWarning;
  return std::nullopt;
}

std::string why_of(const Named& first, const Named& again, const Context& context) {
  if (!is_frame(first.kind) || !is_frame(again.kind)) {
    return "Only the check of the command line (ign sdf -k, gz sdf --check) rejects it: simulators "
           "load the file.";
  }
  const int version = context.root().version;
  if (version < kFirstRejected) {
    return "In SDF " + schema::to_string(schema::Version{version}) + " libsdformat renames the " +
           std::string(again.kind) +
           " while it loads, so what refers to it by name, such as a plugin, does not find it; the "
           "check of the command line rejects the file.";
  }
  return "From SDF 1.7 on libsdformat rejects the file: poses refer to links, joints, frames and "
         "models by name.";
}

void check(const model::Root& /*root*/, Context& context) {
  if (!context.is_sdf()) return;
  for (const NameScope& scope : context.repeated_names()) {
    for_each_repetition(
        scope, Kinds::kDifferent, [&context](const Named& first, const Named& again) {
          context.report(
              {.where = again.where,
               .message = "the " + std::string(again.kind) + " '" + std::string(again.name) +
                          "' has the name of a " + std::string(first.kind),
               .subject = subject_of(again),
               .related = {{first.where, "the " + std::string(first.kind)}},
               .help = "rename one of them, for example by the suffix _" + std::string(again.kind),
               .why = why_of(first, again, context),
               .severity = severity_of(first, again, context)});
        });
  }
}

/// What libsdformat makes of a URDF has joints and links in one set of names.
void check_robot(const model::Root& root, Context& context) {
  if (!context.is_urdf() || root.models.empty()) return;
  const std::vector<SdformatRobot::Part>& parts = context.sdformat_robot().parts;
  // The name of a link that is lumped into another one is free.
  std::unordered_map<std::string_view, const model::Link*> links;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].fate != SdformatRobot::Fate::kLink) continue;
    links.emplace(root.links[i].name.value, &root.links[i]);
  }
  for (const SdformatRobot::Part& part : parts) {
    if (!part.joint || part.fate != SdformatRobot::Fate::kLink) continue;
    const model::Joint& joint = root[part.joint];
    const auto same = links.find(joint.name.value);
    if (same == links.end()) continue;
    context.report({.where = joint.name.span,
                    .message = "the joint '" + joint.name.value + "' has the name of a link",
                    .subject = context.subject(joint),
                    .related = {{same->second->name.span, "the link"}},
                    .help = "rename one of them, for example by the suffix _joint",
                    .why = "In the SDF that libsdformat makes of a URDF joints and links share "
                           "their names: Gazebo rejects the robot, urdfdom and ROS accept it."});
  }
}

Rule rule() {
  return {
      .name = "duplicate-sibling-name",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "siblings of different kinds have the same name",
      .why =
          "A pose may refer to any link, joint, frame or model of a scope by name, so they "
          "share one set of names. From SDF 1.7 on libsdformat rejects the file; in an older "
          "one it renames the later kind while it reads, and references to the name that is "
          "written find the other one, which is a warning. In the SDF that it makes of a URDF the "
          "joints and links "
          "that are left share their names, too: Gazebo rejects the robot, urdfdom and ROS accept "
          "it. A visual with the name of its collision is rejected by the check of the command "
          "line alone (ign sdf -k, gz sdf --check): simulators load it, so that it is an info.",
      .what_to_do = "Rename one of them, for example to elbow_joint.",
      .checks = {on<model::Root>(check), on<model::Root>(check_robot)},
  };
}

}  // namespace rigor::rules::duplicate_sibling_name
