// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands between an element's tags, which decides how it is laid out.

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/xml/document.h>

namespace rigor::author {

enum class ContentKind : std::uint8_t {
  kNothing,   ///< or white space
  kBlock,     ///< elements and comments, a line each
  kText,      ///< text alone
  kVerbatim,  ///< of a <plugin>, or text among elements and comments
};

struct Content {
  ContentKind kind = ContentKind::kNothing;
  std::uint32_t end_token = 0;  ///< the end tag's index in `tokens()`; the tag's own of `<a/>`
};

/// By `Element::index()`, of a complete document.
std::vector<Content> contents(const xml::Document& document);

/// White space, as XML has it.
constexpr bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

/// Whether text is white space.
bool is_blank(std::string_view text);

}  // namespace rigor::author
