// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/reference/srdf_facts.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::srdf_robot_not_found {

void check(const model::Root&, Context& context) {
  const auto robot = missing_robot(context);
  if (!robot) return;
  context.report({.where = robot->where,
                  .message = "no robot named '" + robot->text +
                             "' can be read near this file: names and limits are not checked"});
}

Rule rule() {
  return {
      .name = "srdf-robot-not-found",
      .severity = Severity::kInfo,
      .summary = "the robot of an SRDF is not found",
      .why = "An SRDF has no names of its own: it is about the links and joints of the URDF"
             " whose robot has the same name. Without that nothing in it is checked.",
      .what_to_do = "Keep the URDF or xacro below the folder of the SRDF or one of the "
                    "three around it, with the same robot name; or check both where they "
                    "are together.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::srdf_robot_not_found
