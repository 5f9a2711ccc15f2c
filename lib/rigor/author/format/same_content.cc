// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/same_content.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/author/format/content.h>
#include <rigor/author/format/number_row.h>

namespace rigor::author {
namespace {

using xml::Token;
using xml::TokenKind;

bool same_value(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::optional<std::string> row = number_row(a);
  return row && row == number_row(b);
}

bool same_tag(xml::Element a, xml::Element b) {
  if (a.name() != b.name()) return false;
  const auto of_a = a.attributes();
  const auto of_b = b.attributes();
  auto one = of_a.begin();
  auto other = of_b.begin();
  for (; one != of_a.end() && other != of_b.end(); ++one, ++other) {
    if ((*one).name() != (*other).name()) return false;
    if (!same_value((*one).value(), (*other).value())) return false;
  }
  return one == of_a.end() && other == of_b.end();
}

/// The tokens of a document but for white space between markup, with the elements that their tags begin.
class Walk {
 public:
  explicit Walk(const xml::Document& document) : document_(document) {}

  /// Null at the end.
  const Token* next() {
    const auto& tokens = document_.tokens();
    while (at_ < tokens.size()) {
      const Token& token = tokens[at_++];
      if (token.kind == TokenKind::kStartTag || token.kind == TokenKind::kEmptyTag) ++elements_;
      if (token.kind != TokenKind::kText || !is_blank(bytes(token))) return &token;
    }
    return nullptr;
  }

  std::string_view bytes(const Token& token) const {
    return document_.bytes().substr(token.begin, token.end - token.begin);
  }

  xml::Element element() const { return document_.element(elements_ - 1); }

 private:
  const xml::Document& document_;
  std::size_t at_ = 0;
  std::uint32_t elements_ = 0;
};

/// Of a plugin, with its tags; so the start tag may not differ in length, which is compared apart.
std::string_view plugin_content(const xml::Document& document, xml::Element plugin) {
  const std::string_view whole =
      document.bytes().substr(plugin.tag_span().end, plugin.span().end - plugin.tag_span().end);
  return whole.substr(0, whole.rfind('<'));
}

}  // namespace

bool same_content(const xml::Document& a, const xml::Document& b) {
  Walk of_a(a);
  Walk of_b(b);
  for (;;) {
    const Token* one = of_a.next();
    const Token* other = of_b.next();
    if (one == nullptr || other == nullptr) return one == other;
    if (one->kind != other->kind) return false;
    switch (one->kind) {
      case TokenKind::kStartTag:
      case TokenKind::kEmptyTag: {
        if (!same_tag(of_a.element(), of_b.element())) return false;
        const bool is_plugin =
            one->kind == TokenKind::kStartTag && of_a.element().name() == "plugin";
        if (is_plugin && plugin_content(a, of_a.element()) != plugin_content(b, of_b.element()))
          return false;
        break;
      }
      case TokenKind::kEndTag: break;  // of an element that was compared
      case TokenKind::kText:
        if (!same_value(of_a.bytes(*one), of_b.bytes(*other))) return false;
        break;
      default:
        if (of_a.bytes(*one) != of_b.bytes(*other)) return false;
    }
  }
}

}  // namespace rigor::author
