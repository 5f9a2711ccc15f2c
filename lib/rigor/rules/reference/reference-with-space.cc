// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::reference_with_space {

/// urdfdom compares names byte by byte, so that a space belongs to the name.
void check_name(const model::Field<std::string>& name, const char* what, Context& context) {
  if (!name.written) return;
  const std::string_view text = context.bytes(name.span);
  const std::string_view trimmed = read::trimmed(text);
  if (text.size() == trimmed.size() || trimmed.empty()) return;
  const auto& links = context.root().links;
  const bool spaced = std::any_of(links.begin(), links.end(), [&](const model::Link& link) {
    return context.bytes(link.name.span) == text;
  });
  if (spaced) return;
  context.report(
      {.where = name.span,
       .message = std::string(what) + " '" + std::string(text) +
                  "' has a space in it that the name does not have",
       .fix = Fix{"remove the space", Applicability::kSafe, {{name.span, std::string(trimmed)}}}});
}

void check(const model::Joint& joint, Context& context) {
  check_name(joint.parent, "parent link", context);
  check_name(joint.child, "child link", context);
}

Rule rule() {
  return {
      .name = "reference-with-space",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kAlways},
      .formats = Formats::kUrdf,
      .fix = FixGrade::kSafe,
      .summary = "a joint's reference to a link begins or ends with a space",
      .why = "urdfdom compares names byte by byte, finds no link of the name with the space, and "
             "rejects the robot: so do robot_state_publisher, MoveIt and Gazebo. Readers of SDF "
             "trim the name.",
      .what_to_do = "Remove the space.",
      .checks = {on<model::Joint>(check)},
  };
}

}  // namespace rigor::rules::reference_with_space
