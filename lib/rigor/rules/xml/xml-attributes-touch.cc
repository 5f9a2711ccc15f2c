// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_attributes_touch {

void check(const xml::Fault& fault, Context& context) {
  const Span before{fault.where.source, fault.where.begin, fault.where.begin};
  context.report({.where = fault.where,
                  .message = "no space before this attribute" + and_more(fault),
                  .fix = Fix{"insert a space", Applicability::kSafe, {{before, " "}}}});
}

Rule rule() {
  return {
      .name = "xml-attributes-touch",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "no space stands between two attributes",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom) takes it; strict parsers refuse the file.",
      .what_to_do = "Put a space between them.",
      .checks = {on_xml({xml::FaultKind::kNoSpaceBetween}, check)},
  };
}

}  // namespace rigor::rules::xml_attributes_touch
