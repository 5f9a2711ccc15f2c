// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::xml_doctype {

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "a DOCTYPE is ignored: entities that it defines are not replaced",
                  .fix = Fix{"remove it", Applicability::kUnsafe, {without(context, fault.where)}},
                  // tinyxml2 ends it at the first '>', and what follows is text before the root.
                  .refused = context.bytes(fault.where).find('[') != std::string_view::npos});
}

Rule rule() {
  return {
      .name = "xml-doctype",
      .severity = Severity::kWarning,
      .refused = {.urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "the file has a DOCTYPE",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) ignores it, so that an entity which it "
             "defines is never replaced. Neither SDF nor URDF has one.",
      .what_to_do = "Remove it, and write out the entities that it defines.",
      .checks = {on_xml({xml::FaultKind::kDoctype}, check)},
  };
}

}  // namespace rigor::rules::xml_doctype
