// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_text_outside_root {

void check(const xml::Fault& fault, Context& context) {
  context.report(
      {.where = fault.where,
       .message = "text outside the root element" + and_more(fault),
       .fix = Fix{"remove it", Applicability::kUnsafe, {without(context, fault.where)}}});
}

Rule rule() {
  return {
      .name = "xml-text-outside-root",
      .severity = Severity::kWarning,
      .refused = {.urdf = Refusal::kAlways},
      .fix = FixGrade::kUnsafe,
      .summary = "text before the root element",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) drops it; strict parsers reject the file. "
             "Behind the root element tinyxml2 rejects it too, and the file is not well-formed.",
      .what_to_do = "Remove the characters, or make them a comment.",
      .checks = {on_xml({xml::FaultKind::kTextOutsideRoot}, check)},
  };
}

}  // namespace rigor::rules::xml_text_outside_root
