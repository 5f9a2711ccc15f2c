// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_declaration_malformed {

/// Python's parsers read a declaration of any version; libxml2's do not.
std::optional<Severity> severity_of(const xml::Fault& fault) {
  if (fault.detail.ends_with(" is no version")) return Severity::kInfo;
  return std::nullopt;
}

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "the XML declaration is malformed: " + fault.detail,
                  .fix = Fix{R"(write <?xml version="1.0"?>)",
                             Applicability::kSafe,
                             {{fault.where, R"(<?xml version="1.0"?>)"}}},
                  .severity = severity_of(fault)});
}

Rule rule() {
  return {
      .name = "xml-declaration-malformed",
      .severity = Severity::kError,
      .fix = FixGrade::kSafe,
      .summary = "the XML declaration is malformed",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) ignores the declaration, but Python's XML "
             "parsers reject the file, and with them xacro and the ROS tools that are written in "
             "Python. A version that does not exist (0.0) is read by Python's parsers and rejected "
             "by libxml2 (xmllint, lxml): it is an info.",
      .what_to_do = "Write <?xml version=\"1.0\"?>, followed by an encoding if needed, or remove "
                    "it: XML without a declaration is UTF-8.",
      .checks = {on_xml({xml::FaultKind::kBadDeclaration}, check)},
  };
}

}  // namespace rigor::rules::xml_declaration_malformed
