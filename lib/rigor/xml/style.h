// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How an XML file is laid out, derived from the file itself: what stands nearest to the place in question
// decides, because real files are mixtures.
//
//   std::string line = indentation(document, link) + indent_unit(document, link) + "<inertial>";

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/xml/document.h>

namespace rigor::xml {

/// White space that ends no line.
inline constexpr std::string_view kBlanks = " \t";

/// The white space that the element's line begins with; none where a byte-order mark does.
std::string indentation(const Document& document, Element element);

/// Whether only white space stands before the element on its line.
bool stands_first(const Document& document, Element element);

/// Whether it is written `<a/>`.
bool is_empty_tag(const Document& document, Element element);

/// What a level adds to the indentation: spaces or a tab; two spaces where nothing tells.
std::string indent_unit(const Document& document, Element near);

/// "\n" or "\r\n": the first line end at or behind an offset, else the last before it.
std::string_view line_end(const Document& document, std::uint32_t at);

/// What attribute values stand in; `"` where nothing tells.
char quote(const Document& document, Element near);

/// How an empty element ends: "/>" or " />"; the former where nothing tells.
std::string_view self_close(const Document& document, Element near);

/// `xml`, written with `"` and "/>", with the quotes and ends that the author uses near `near`.
std::string in_style(const Document& document, Element near, std::string_view xml);

}  // namespace rigor::xml
