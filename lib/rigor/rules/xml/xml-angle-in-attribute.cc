// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_angle_in_attribute {

/// Whether it begins the next tag, behind one whose value was not closed.
bool is_next_tag(Span where, const Context& context) {
  constexpr std::uint32_t kFar = 200;
  const Span before{where.source, where.begin > kFar ? where.begin - kFar : 0, where.begin};
  const std::string_view bytes = context.bytes(before);
  const std::size_t last = bytes.find_last_not_of(" \t\r\n");
  return last != bytes.npos && bytes[last] == '>';
}

void check(const xml::Fault& fault, Context& context) {
  Finding finding{.where = fault.where,
                  .message = "'<' is not allowed in an attribute value" + and_more(fault)};
  if (is_next_tag(fault.where, context)) {
    finding.help = "a tag begins here: is the quote missing at the end of the value before it?";
  } else {
    finding.fix = Fix{"write &lt;", Applicability::kSafe, {{fault.where, "&lt;"}}};
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "xml-angle-in-attribute",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "an attribute's value holds '<'",
      .why =
          "tinyxml2 (libsdformat, Gazebo, urdfdom 4) accepts it; strict parsers reject the file.",
      .what_to_do = "Write &lt; for the character '<'.",
      .checks = {on_xml({xml::FaultKind::kAngleInValue}, check)},
  };
}

}  // namespace rigor::rules::xml_angle_in_attribute
