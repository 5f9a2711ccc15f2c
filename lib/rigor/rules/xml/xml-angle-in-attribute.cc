// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_angle_in_attribute {

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "'<' may not stand in an attribute's value" + and_more(fault),
                  .fix = Fix{"write &lt;", Applicability::kSafe, {{fault.where, "&lt;"}}}});
}

Rule rule() {
  return {
      .name = "xml-angle-in-attribute",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "an attribute's value holds '<'",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom) takes it; strict parsers refuse the file.",
      .what_to_do = "Write &lt; for the character '<'.",
      .checks = {on_xml({xml::FaultKind::kAngleInValue}, check)},
  };
}

}  // namespace rigor::rules::xml_angle_in_attribute
