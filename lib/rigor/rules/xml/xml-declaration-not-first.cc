// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::xml_declaration_not_first {

constexpr std::uint32_t kByteOrderMarkSize = 3;

std::optional<Fix> remove_space_before(Span declaration, std::string_view bytes) {
  Span before{declaration.source, 0, declaration.begin};
  if (bytes.starts_with("\xEF\xBB\xBF")) before.begin = kByteOrderMarkSize;
  if (!read::trimmed(bytes.substr(before.begin, before.size())).empty()) return std::nullopt;
  return Fix{"remove the white space before the declaration", Applicability::kSafe, {{before, ""}}};
}

void check(const xml::Fault& fault, Context& context) {
  std::optional<Fix> fix = remove_space_before(fault.where, context.document().bytes());
  const bool refused = !fix;  // tinyxml2 skips white space only
  context.report({.where = fault.where,
                  .message = "the XML declaration is not the first thing in the file",
                  .fix = std::move(fix),
                  .refused = refused,
                  .why = refused ? "tinyxml2 (libsdformat, Gazebo, urdfdom 4) rejects the file."
                                 : "tinyxml2 accepts it after white space; Python's XML parsers "
                                   "and xmllint reject the file, and with them the ROS tools that "
                                   "are written in Python.",
                  .severity = refused ? Severity::kError : Severity::kWarning});
}

Rule rule() {
  return {
      .name = "xml-declaration-not-first",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kSafe,
      .summary = "the XML declaration is not the first thing in the file",
      .why =
          "XML allows a declaration at the very start only. After an element or a comment tinyxml2 "
          "(libsdformat, Gazebo, urdfdom 4) rejects the file (TinyXML 1, with which urdfdom 3 "
          "reads, accepts it). After a blank line it does not, but Python's XML parsers do, and "
          "with them the ROS tools that are written in Python: that is a warning.",
      .what_to_do =
          "Move the declaration to the first line, or remove it: XML without one is UTF-8 already.",
      .checks = {on_xml({xml::FaultKind::kDeclarationNotFirst}, check)},
  };
}

}  // namespace rigor::rules::xml_declaration_not_first
