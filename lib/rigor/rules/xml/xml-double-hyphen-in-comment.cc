// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_double_hyphen_in_comment {

/// In place of all hyphens of the comment that stand together. What looks like the option of a program,
/// `--verbose`, is left: it may be copied from there.
std::optional<Fix> write_equals(const xml::Fault& fault, std::string_view bytes) {
  const std::size_t end = bytes.find("-->", fault.where.begin);
  if (end == std::string_view::npos) return std::nullopt;
  Fix fix{"write '=='", Applicability::kSafe, {}};
  for (std::size_t at = fault.where.begin; at < end;) {
    const std::size_t first = bytes.find('-', at);
    at = std::min(bytes.find_first_not_of('-', first), end);
    const bool touches_end = at == end && first < end;
    if (first >= end || (at - first < 2 && !touches_end)) continue;
    const bool option = at - first == 2 && std::isalnum(static_cast<unsigned char>(bytes[at])) != 0;
    if (option) return std::nullopt;
    Span hyphens = fault.where;
    hyphens.begin = static_cast<std::uint32_t>(first);
    hyphens.end = static_cast<std::uint32_t>(at);
    fix.edits.push_back({hyphens, std::string(hyphens.size(), '=')});
  }
  return fix;
}

void check(const xml::Fault& fault, Context& context) {
  context.report({.where = fault.where,
                  .message = "'--' is not allowed inside a comment" + and_more(fault),
                  .fix = write_equals(fault, context.document().bytes())});
}

Rule rule() {
  return {
      .name = "xml-double-hyphen-in-comment",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "a comment holds '--'",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) accepts it; strict parsers, Python's among "
             "them, reject the whole file, and with them the ROS tools that are written in Python.",
      .what_to_do = "Write another line of characters, as in <!-- ===== wheels ===== -->.",
      .checks = {on_xml({xml::FaultKind::kHyphensInComment}, check)},
  };
}

}  // namespace rigor::rules::xml_double_hyphen_in_comment
