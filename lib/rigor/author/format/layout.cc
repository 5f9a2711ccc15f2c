// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/layout.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/author/format/content.h>
#include <rigor/author/format/number_row.h>
#include <rigor/author/format/tag.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using xml::Token;
using xml::TokenKind;

/// One walk over the tokens. A gap is the white space between two pieces of markup.
class Layout {
 public:
  Layout(const xml::Document& document, const FormatStyle& style)
      : document_(document),
        style_(style),
        contents_(contents(document)),
        line_end_(xml::line_end(document, 0)) {}

  std::vector<Edit> edits() {
    const auto& tokens = document_.tokens();
    for (std::uint32_t i = 0; i < tokens.size(); ++i) i = place(i);
    const auto end = static_cast<std::uint32_t>(document_.bytes().size());
    replace(gap_begin_, end, line_end_);
    return std::move(edits_);
  }

 private:
  /// What the gap stands behind.
  enum class Behind : std::uint8_t { kNothing, kDeclaration, kStartTag, kOther };

  /// The last token that belongs to what begins with this one.
  std::uint32_t place(std::uint32_t index) {
    const Token& token = document_.tokens()[index];
    switch (token.kind) {
      case TokenKind::kText:
        return index;  // a gap: other text is part of an element that is placed whole
      case TokenKind::kByteOrderMark: gap_begin_ = token.end; return index;
      case TokenKind::kStartTag:
      case TokenKind::kEmptyTag: return place_element(index);
      case TokenKind::kEndTag: {
        --depth_;
        const xml::Element element = document_.element(open_.back());
        open_.pop_back();
        begin_line(token.begin, BlankLine::kNone);
        replace_end_tag(token, element);
        pass(token.end, Behind::kOther);
        return index;
      }
      case TokenKind::kComment:
        if (stands_behind(token)) {
          replace(gap_begin_, token.begin, " ");
        } else {
          begin_line(token.begin, BlankLine::kKeep);
        }
        pass(token.end, Behind::kOther);
        return index;
      default:
        begin_line(token.begin, BlankLine::kKeep);
        pass(token.end,
             token.kind == TokenKind::kDeclaration ? Behind::kDeclaration : Behind::kOther);
        return index;
    }
  }

  std::uint32_t place_element(std::uint32_t index) {
    const Token& token = document_.tokens()[index];
    const xml::Element element = document_.element(next_element_++);
    const Content& content = contents_[element.index()];
    begin_line(token.begin, BlankLine::kKeep);
    text_.clear();
    add_tag(text_, document_, element, style_, indent(), line_end_);
    replace(token.begin, token.end, text_);
    if (token.kind == TokenKind::kEmptyTag) {
      pass(token.end, Behind::kOther);
      return index;
    }
    if (content.kind == ContentKind::kBlock) {
      open_.push_back(element.index());
      ++depth_;
      pass(token.end, Behind::kStartTag);
      return index;
    }
    const Token& end = document_.tokens()[content.end_token];
    if (content.kind != ContentKind::kVerbatim) place_text(token.end, end.begin);
    replace_end_tag(end, element);
    skip_elements(index + 1, content.end_token);
    pass(end.end, Behind::kOther);
    return content.end_token;
  }

  /// Between the tags of an element that has no other content.
  void place_text(std::uint32_t begin, std::uint32_t end) {
    const std::string_view text = document_.bytes().substr(begin, end - begin);
    if (is_blank(text)) {
      replace(begin, end, {});
    } else if (std::optional<std::string> row = number_row(text)) {
      replace(begin, end, *row);
    }
  }

  void skip_elements(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i) {
      const TokenKind kind = document_.tokens()[i].kind;
      if (kind == TokenKind::kStartTag || kind == TokenKind::kEmptyTag) ++next_element_;
    }
  }

  /// Whether a comment says something of what stands before it on its line.
  bool stands_behind(const Token& comment) const {
    if (behind_ == Behind::kNothing || behind_ == Behind::kDeclaration) return false;
    return gap(comment.begin).find('\n') == std::string_view::npos;
  }

  enum class BlankLine : std::uint8_t { kKeep, kNone };

  void begin_line(std::uint32_t at, BlankLine blank) {
    text_.clear();
    if (behind_ != Behind::kNothing) {
      const std::string_view found = gap(at);
      const bool has_blank = std::count(found.begin(), found.end(), '\n') > 1;
      text_ += line_end_;
      if (has_blank && blank == BlankLine::kKeep && behind_ != Behind::kStartTag)
        text_ += line_end_;
    }
    text_ += indent();
    replace(gap_begin_, at, text_);
  }

  void replace_end_tag(const Token& token, xml::Element element) {
    text_ = "</";
    text_ += element.name();
    text_ += '>';
    replace(token.begin, token.end, text_);
  }

  std::string_view gap(std::uint32_t end) const {
    return document_.bytes().substr(gap_begin_, end - gap_begin_);
  }

  /// Of the depth.
  std::string_view indent() {
    const std::size_t size = depth_ * style_.indent.size();
    while (indent_.size() < size) indent_ += style_.indent;
    return std::string_view(indent_).substr(0, size);
  }

  void pass(std::uint32_t end, Behind behind) {
    gap_begin_ = end;
    behind_ = behind;
  }

  /// Edits that touch are one: two in one place have no order.
  void replace(std::uint32_t begin, std::uint32_t end, std::string_view text) {
    if (document_.bytes().substr(begin, end - begin) == text) return;
    if (!edits_.empty() && edits_.back().span.end == begin) {
      edits_.back().span.end = end;
      edits_.back().text += text;
      return;
    }
    edits_.push_back({{document_.source(), begin, end}, std::string(text)});
  }

  const xml::Document& document_;
  const FormatStyle& style_;
  const std::vector<Content> contents_;
  const std::string_view line_end_;
  std::vector<Edit> edits_;
  std::vector<std::uint32_t> open_;  // blocks, by index
  std::string indent_;               // of the greatest depth so far
  std::string text_;                 // what is written next
  std::uint32_t depth_ = 0;
  std::uint32_t next_element_ = 0;
  std::uint32_t gap_begin_ = 0;
  Behind behind_ = Behind::kNothing;
};

}  // namespace

std::vector<Edit> layout_edits(const xml::Document& document, const FormatStyle& style) {
  return Layout(document, style).edits();
}

}  // namespace rigor::author
