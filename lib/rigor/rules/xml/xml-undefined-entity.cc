// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_undefined_entity {

/// As every reader takes it. Of an entity that a DOCTYPE may define, only some take it so.
std::optional<Fix> write_ampersand(const xml::Fault& fault, const Context& context) {
  const auto& faults = context.document().faults();
  const auto is_doctype = [](const xml::Fault& of) { return of.kind == xml::FaultKind::kDoctype; };
  if (std::any_of(faults.begin(), faults.end(), is_doctype)) return std::nullopt;
  const Span after_ampersand{fault.where.source, fault.where.begin + 1, fault.where.begin + 1};
  return Fix{"write &amp;", Applicability::kSafe, {{after_ampersand, "amp;"}}};
}

void check(const xml::Fault& fault, Context& context) {
  const std::string written(context.bytes(fault.where));
  context.report({.where = fault.where,
                  .message = (written == "&" ? "'&' on its own"
                                             : "'" + written + "' is no entity that XML defines") +
                             and_more(fault),
                  .help = "the character '&' is written &amp;",
                  .fix = write_ampersand(fault, context)});
}

Rule rule() {
  return {
      .name = "xml-undefined-entity",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "'&' begins no entity that XML defines",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom) leaves the characters as they stand, also "
             "where a DOCTYPE defines the entity; strict parsers refuse the file.",
      .what_to_do = "Write &amp; for the character '&'; what an entity was meant to stand for is "
                    "written out.",
      .checks = {on_xml({xml::FaultKind::kUndefinedEntity}, check)},
  };
}

}  // namespace rigor::rules::xml_undefined_entity
