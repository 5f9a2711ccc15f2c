// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string_view>

#include <rigor/rules/kinematics/unknown_type.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::joint_type_unknown {

void check(const read::SchemaFact& fact, Context& context) {
  if (!is_type_of(fact, "joint")) return;
  // libsdformat does not mind the case of letters, urdfdom does.
  const auto same = [&fact](std::string_view type) {
    return schema::edit_distance(fact.text, type, 0) == 0;
  };
  const auto types = types_of(fact);
  if (context.is_sdf() && std::any_of(types.begin(), types.end(), same)) return;
  report_unknown_type(fact, context);
}

void check_empty(const model::Joint& joint, Context& context) {
  report_empty_type(joint.site, context.subject(joint), context);
}

Rule rule() {
  return {
      .name = "joint-type-unknown",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "a joint has a type that does not exist",
      .why = "libsdformat rejects the file. urdfdom rejects the robot.",
      .what_to_do =
          "SDF knows revolute, continuous, prismatic, fixed, ball, screw, universal, revolute2 and "
          "gearbox; URDF revolute, continuous, prismatic, fixed, floating and planar.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check),
                 on<model::Joint>(check_empty)},
  };
}

}  // namespace rigor::rules::joint_type_unknown
