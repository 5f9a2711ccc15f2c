// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/content.h>

#include <algorithm>
#include <string_view>

namespace rigor::author {
namespace {

/// Of an element whose end is not seen yet.
struct Open {
  std::uint32_t element;
  bool has_text = false;
  bool has_markup = false;  // elements, comments, instructions
};

ContentKind kind_of(const Open& open, std::string_view name) {
  if (name == "plugin" || (open.has_text && open.has_markup)) return ContentKind::kVerbatim;
  if (!open.has_text && !open.has_markup) return ContentKind::kNothing;
  return open.has_text ? ContentKind::kText : ContentKind::kBlock;
}

}  // namespace

bool is_blank(std::string_view text) { return std::all_of(text.begin(), text.end(), is_space); }

std::vector<Content> contents(const xml::Document& document) {
  std::vector<Content> found(document.element_count());
  std::vector<Open> open;
  std::uint32_t next = 0;
  const auto& tokens = document.tokens();
  for (std::uint32_t i = 0; i < tokens.size(); ++i) {
    const xml::Token& token = tokens[i];
    const bool is_text = token.kind == xml::TokenKind::kText;
    if (token.kind == xml::TokenKind::kEndTag) {
      const Open& ended = open.back();
      found[ended.element] = {kind_of(ended, document.element(ended.element).name()), i};
      open.pop_back();
      continue;
    }
    if (!open.empty()) {
      if (is_text || token.kind == xml::TokenKind::kCData) {
        const auto text = document.bytes().substr(token.begin, token.end - token.begin);
        open.back().has_text = open.back().has_text || !is_text || !is_blank(text);
      } else {
        open.back().has_markup = true;
      }
    }
    if (token.kind == xml::TokenKind::kStartTag) open.push_back({next++});
    if (token.kind == xml::TokenKind::kEmptyTag) found[next++] = {ContentKind::kNothing, i};
  }
  return found;
}

}  // namespace rigor::author
