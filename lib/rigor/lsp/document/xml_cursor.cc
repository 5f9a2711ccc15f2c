// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/xml_cursor.h>

#include <algorithm>

namespace rigor::lsp {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_bracket(char c) { return c == '<' || c == '>'; }
bool ends_name(char c) { return is_blank(c) || is_bracket(c) || c == '/'; }

/// The first from `begin` on that is so, or npos. `find_first_of` takes several times as long for each byte.
template <class Is>
std::size_t find_where(std::string_view text, std::size_t begin, const Is& is) {
  while (begin < text.size() && !is(text[begin])) ++begin;
  return begin < text.size() ? begin : std::string_view::npos;
}

/// Walks over the bytes before the place once.
class CursorScanner {
 public:
  CursorScanner(std::string_view text, std::uint32_t offset) : text_(text.substr(0, offset)) {}

  XmlCursor scan() && {
    while (at_ < text_.size()) {
      const std::size_t tag = text_.find('<', at_);
      if (tag == std::string_view::npos) break;
      at_ = tag;
      const std::string_view rest = text_.substr(tag);
      if (rest.starts_with("<!--")) {
        if (!skip_past("-->")) return elsewhere();
      } else if (rest.starts_with("<![CDATA[")) {
        if (!skip_past("]]>")) return elsewhere();
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        if (!skip_past(">")) return elsewhere();
      } else if (rest.starts_with("</")) {
        if (!end_tag()) return std::move(cursor_);
      } else if (!start_tag()) {
        return std::move(cursor_);
      }
    }
    cursor_.at = XmlCursor::At::kText;
    return typed_from(text_begin_);
  }

 private:
  bool skip_past(std::string_view mark) {
    const std::size_t end = text_.find(mark, at_ + 2);
    if (end == std::string_view::npos) return false;
    at_ = text_begin_ = end + mark.size();
    return true;
  }

  XmlCursor elsewhere() {
    cursor_.at = XmlCursor::At::kElsewhere;
    return typed_from(at_);
  }

  XmlCursor typed_from(std::size_t begin) {
    cursor_.begin = static_cast<std::uint32_t>(begin);
    cursor_.typed = text_.substr(begin);
    return std::move(cursor_);
  }

  bool end_tag() {
    const std::size_t end = find_where(text_, at_ + 2, is_bracket);
    if (end == std::string_view::npos) {
      cursor_.at = XmlCursor::At::kEndTagName;
      cursor_ = typed_from(at_ + 2);
      return false;
    }
    std::string_view name = text_.substr(at_ + 2, end - at_ - 2);
    while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
    const auto match = std::find_if(cursor_.open.rbegin(), cursor_.open.rend(),
                                    [name](const OpenElement& open) { return open.name == name; });
    if (match != cursor_.open.rend()) cursor_.open.erase(match.base() - 1, cursor_.open.end());
    at_ = text_begin_ = text_[end] == '>' ? end + 1 : end;
    return true;
  }

  /// A tag that is not closed before the next begins ends there.
  bool start_tag() {
    const std::size_t name_begin = at_ + 1;
    std::size_t end = find_where(text_, name_begin, ends_name);
    if (end == std::string_view::npos) {
      cursor_.at = XmlCursor::At::kTagName;
      cursor_ = typed_from(name_begin);
      return false;
    }
    OpenElement element{text_.substr(name_begin, end - name_begin), {}};
    const std::size_t attributes = end;
    char quote = '\0';
    for (; end < text_.size(); ++end) {
      const char c = text_[end];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>' || c == '<') {
        break;
      }
    }
    element.tag = text_.substr(attributes, end - attributes);
    if (end == text_.size()) {
      cursor_.open.push_back(element);
      in_tag(attributes, quote);
      return false;
    }
    const bool is_empty = text_[end] == '>' && text_[end - 1] == '/';
    if (!is_empty) cursor_.open.push_back(element);
    at_ = text_begin_ = text_[end] == '>' ? end + 1 : end;
    return true;
  }

  void in_tag(std::size_t attributes, char quote) {
    if (quote != '\0') {
      const std::size_t open = open_quote(attributes, quote);
      std::size_t name_end = text_.find_last_not_of("= \t\r\n", open - 1);
      name_end =
          name_end == std::string_view::npos || name_end < attributes ? attributes : name_end + 1;
      std::size_t name = name_end;
      while (name > attributes && !is_blank(text_[name - 1]) && text_[name - 1] != '"' &&
             text_[name - 1] != '\'')
        --name;
      cursor_.at = XmlCursor::At::kAttributeValue;
      cursor_.attribute = text_.substr(name, name_end - name);
      cursor_ = typed_from(open + 1);
      return;
    }
    cursor_.at = XmlCursor::At::kAttributeName;
    const std::size_t before = text_.find_last_of(" \t\r\n\"'=/");
    cursor_ = typed_from(before == std::string_view::npos ? attributes : before + 1);
  }

  std::size_t open_quote(std::size_t attributes, char quote) const {
    bool inside = false;
    std::size_t open = attributes;
    char current = '\0';
    for (std::size_t i = attributes; i < text_.size(); ++i) {
      if (inside) {
        if (text_[i] == current) inside = false;
      } else if (text_[i] == '"' || text_[i] == '\'') {
        inside = true;
        current = text_[i];
        open = i;
      }
    }
    return current == quote ? open : attributes;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t text_begin_ = 0;
  XmlCursor cursor_;
};

}  // namespace

XmlCursor xml_cursor(std::string_view text, std::uint32_t offset) {
  return CursorScanner(text, offset).scan();
}

std::string_view attribute_in(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    if (at == 0 || !is_blank(tag[at - 1])) continue;
    const std::size_t quote = tag.find_first_not_of("= \t\r\n", at + name.size());
    if (quote == std::string_view::npos || (tag[quote] != '"' && tag[quote] != '\'')) continue;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    return tag.substr(quote + 1, end == std::string_view::npos ? end : end - quote - 1);
  }
  return {};
}

}  // namespace rigor::lsp
