// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What somebody is typing at a place of an XML document, whatever stands behind it. Only the bytes before the
// place are read, so that a half-written tag does not matter.
//
//   const XmlCursor cursor = xml_cursor(text, offset);
//   if (cursor.at == XmlCursor::At::kAttributeValue) complete(cursor.open, cursor.attribute, cursor.typed);

#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor::lsp {

struct OpenElement {
  std::string_view name;
  std::string_view tag;  ///< behind the name, up to the end of the start tag: its attributes
};

struct XmlCursor {
  enum class At : std::uint8_t {
    kText,
    kTagName,
    kEndTagName,
    kAttributeName,
    kAttributeValue,
    kElsewhere,  ///< a comment, CDATA or a declaration
  };
  At at = At::kText;
  /// Elements around the place, the outermost first; that whose start tag is typed is the last.
  std::vector<OpenElement> open;
  std::string_view attribute;  ///< the name, at a value
  std::string_view typed;      ///< of the name, value or text, what is before the place
  std::uint32_t begin = 0;     ///< byte offset of `typed`
};

XmlCursor xml_cursor(std::string_view text, std::uint32_t offset);

/// The value of an attribute in `OpenElement::tag`, as it is written; empty when it is not there.
std::string_view attribute_in(std::string_view tag, std::string_view name);

}  // namespace rigor::lsp
