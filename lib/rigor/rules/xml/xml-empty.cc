// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_empty {

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where, .message = "the file holds no element"});
}

Rule rule() {
  return {
      .name = "xml-empty",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "the file holds no element",
      .why = "libsdformat, Gazebo and urdfdom find nothing to load and refuse it. Often a "
             "generator failed and left an empty file behind.",
      .what_to_do = "Write the model, or remove the file.",
      .checks = {on_xml({xml::FaultKind::kEmpty}, check)},
  };
}

}  // namespace rigor::rules::xml_empty
