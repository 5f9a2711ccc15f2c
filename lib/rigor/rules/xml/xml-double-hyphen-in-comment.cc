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

/// The `<!--` of the comment around the hyphens of another `<!--`; nothing for other hyphens.
std::optional<Span> still_open(const xml::Fault& fault, std::string_view bytes) {
  constexpr std::string_view kOpen = "<!--";
  const std::size_t inner = fault.where.begin - 2;
  if (fault.where.begin < kOpen.size() || bytes.substr(inner, kOpen.size()) != kOpen)
    return std::nullopt;
  const std::size_t outer = bytes.rfind(kOpen, inner - 1);
  if (outer == bytes.npos) return std::nullopt;
  Span open = fault.where;
  open.begin = static_cast<std::uint32_t>(outer);
  open.end = static_cast<std::uint32_t>(outer + kOpen.size());
  return open;
}

void check(const xml::Fault& fault, Context& context) {
  if (const auto open = still_open(fault, context.document().bytes())) {
    const auto line = context.sources().position(open->source, open->begin).line;
    context.report({.where = fault.where,
                    .message = "'<!--' inside a comment: the one that opened at line " +
                               std::to_string(line) + " is still open" + and_more(fault),
                    .related = {{*open, "opened here"}},
                    .help = "close it with '-->' before this line, or take this '<!--' out"});
    return;
  }
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
      .what_to_do = "Write another line of characters, as in <!-- ===== wheels ===== -->. Comments "
                    "do not nest: close the outer one first.",
      .checks = {on_xml({xml::FaultKind::kHyphensInComment}, check)},
  };
}

}  // namespace rigor::rules::xml_double_hyphen_in_comment
