// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_declaration_malformed {

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "the XML declaration is malformed: " + fault.detail,
                  .fix = Fix{R"(write <?xml version="1.0"?>)",
                             Applicability::kSafe,
                             {{fault.where, R"(<?xml version="1.0"?>)"}}}});
}

Rule rule() {
  return {
      .name = "xml-declaration-malformed",
      .severity = Severity::kError,
      .fix = FixGrade::kSafe,
      .summary = "the XML declaration is not written as XML has it",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom) does not look into it, but Python's and "
             "every other strict parser refuses the file, and with them xacro and the ROS tools "
             "that are written in Python.",
      .what_to_do = "Write <?xml version=\"1.0\"?>, with an encoding behind the version if you "
                    "like, or remove it: XML without one is UTF-8 already.",
      .checks = {on_xml({xml::FaultKind::kBadDeclaration}, check)},
  };
}

}  // namespace rigor::rules::xml_declaration_malformed
