// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/comments.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/xml/token.h>

namespace rigor::convert {

std::vector<std::string> comments_before(const xml::Document& document, xml::Element element) {
  constexpr std::string_view kOpen = "<!--", kClose = "-->";
  const auto& tokens = document.tokens();
  const auto first =
      std::lower_bound(tokens.begin(), tokens.end(), element.span().begin,
                       [](const xml::Token& token, std::uint32_t at) { return token.begin < at; });
  const auto text = [&](std::size_t i) {
    return document.bytes().substr(tokens[i].begin, tokens[i].end - tokens[i].begin);
  };
  std::vector<std::string> comments;
  for (auto i = static_cast<std::size_t>(first - tokens.begin()); i-- > 0;) {
    if (tokens[i].kind == xml::TokenKind::kComment) {
      const std::string_view comment = text(i);
      const bool own_line = i > 0 && tokens[i - 1].kind == xml::TokenKind::kText &&
                            text(i - 1).find('\n') != std::string_view::npos;
      if (!own_line || comment.size() < kOpen.size() + kClose.size()) break;
      comments.emplace_back(
          comment.substr(kOpen.size(), comment.size() - kOpen.size() - kClose.size()));
    } else if (tokens[i].kind != xml::TokenKind::kText || !read::trimmed(text(i)).empty()) {
      break;
    }
  }
  std::reverse(comments.begin(), comments.end());
  return comments;
}

}  // namespace rigor::convert
