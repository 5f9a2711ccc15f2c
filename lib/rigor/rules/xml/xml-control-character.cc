// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_control_character {

/// Of a name or value it is a part, as most consumers read it.
Applicability fix_of_character(const xml::Fault& fault, const Context& context) {
  const auto& tokens = context.document().tokens();
  const auto behind = std::upper_bound(
      tokens.begin(), tokens.end(), fault.where.begin,
      [](std::uint32_t place, const xml::Token& token) { return place < token.end; });
  const bool comment = behind != tokens.end() && behind->kind == xml::TokenKind::kComment;
  return comment ? Applicability::kSafe : Applicability::kUnsafe;
}

void check(const xml::Fault& fault, Context& context) {
  const std::string_view bytes = context.bytes(fault.where);
  const unsigned first = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
  context.report({.where = fault.where,
                  .message = fmt::format("the control character U+{:04X} is not allowed in XML{}",
                                         first, and_more(fault)),
                  .fix = Fix{"remove it", fix_of_character(fault, context), {{fault.where, ""}}}});
}

Rule rule() {
  return {
      .name = "xml-control-character",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "the file holds a control character",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom 4) takes all but zero bytes; strict parsers "
             "reject the file. XML forbids them.",
      .what_to_do = "Remove the character; it cannot be seen in most editors.",
      .checks = {on_xml({xml::FaultKind::kControlCharacter}, check)},
  };
}

}  // namespace rigor::rules::xml_control_character
