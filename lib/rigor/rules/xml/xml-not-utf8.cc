// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::xml_not_utf8 {

/// Where the declaration names the encoding; nowhere when it does not.
Span declared_encoding(const Context& context) {
  const std::string_view bytes = context.document().bytes();
  const std::size_t start = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  if (!bytes.substr(start).starts_with("<?xml ")) return {};
  const std::string_view declaration = bytes.substr(0, bytes.find("?>", start));
  const std::size_t open = declaration.find_first_of("\"'", declaration.find("encoding"));
  if (declaration.find("encoding") == declaration.npos || open == declaration.npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == declaration.npos) return {};
  return {context.root().source, static_cast<std::uint32_t>(open + 1),
          static_cast<std::uint32_t>(close)};
}

/// Every character of these is two or four bytes wide, so a file that was read as UTF-8 is in none.
void check_declaration(const model::Root& /*root*/, Context& context) {
  const Span where = declared_encoding(context);
  const std::string_view name = where.nowhere() ? std::string_view() : context.bytes(where);
  for (const std::string_view wide : {"utf-16", "utf-32", "ucs-2", "ucs-4"}) {
    if (schema::edit_distance(name.substr(0, wide.size()), wide, 0) != 0) continue;
    context.report(
        {.where = where,
         .message = "the declaration says " + std::string(name) + ", but the file is UTF-8",
         .fix = Fix{"write UTF-8", Applicability::kSafe, {{where, "UTF-8"}}}});
    return;
  }
}

void check(const xml::Fault& fault, Context& context) {
  const std::string_view bytes = context.bytes(fault.where);
  const unsigned first = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
  context.report({.where = fault.where,
                  .message = fmt::format("the byte 0x{:02X} is not part of UTF-8 here{}", first,
                                         and_more(fault))});
}

Rule rule() {
  return {
      .name = "xml-not-utf8",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "the file holds bytes that are not UTF-8, or says that it is UTF-16",
      .why = "tinyxml2 (libsdformat, Gazebo, urdfdom) passes them on as they are, so names become "
             "unreadable; strict parsers refuse the file. They come from editors that save Latin-1 "
             "or a Windows code page. A declaration that names UTF-16 in a file of single bytes "
             "they refuse as well.",
      .what_to_do = "Save the file as UTF-8.",
      .checks = {on_xml({xml::FaultKind::kNotUtf8}, check), on<model::Root>(check_declaration)},
  };
}

}  // namespace rigor::rules::xml_not_utf8
