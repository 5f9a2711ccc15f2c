// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/edit.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include <rigor/xml/style.h>

namespace rigor::xml {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

/// The first byte at or behind `at` that is none of `set`.
std::uint32_t skip(std::string_view bytes, std::uint32_t at, std::string_view set) {
  return static_cast<std::uint32_t>(std::min(bytes.find_first_not_of(set, at), bytes.size()));
}

/// Past the last byte before `at` that is none of `set`.
std::uint32_t skip_back(std::string_view bytes, std::uint32_t at, std::string_view set) {
  return static_cast<std::uint32_t>(bytes.substr(0, at).find_last_not_of(set) + 1);
}

std::string_view trimmed(std::string_view text) {
  text.remove_suffix(text.size() -
                     skip_back(text, static_cast<std::uint32_t>(text.size()), kSpace));
  return text.substr(skip(text, 0, kSpace));
}

bool ends_line(std::string_view bytes, std::uint32_t at) {
  return at == bytes.size() || bytes[at] == '\n' || bytes.substr(at, 2) == "\r\n";
}

/// Past the comments behind `at` on its line, when nothing else follows there; else `at`.
std::uint32_t skip_comments(std::string_view bytes, std::uint32_t at) {
  constexpr std::string_view kOpen = "<!--";
  constexpr std::string_view kClose = "-->";
  std::uint32_t past = at;
  while (true) {
    const std::uint32_t next = skip(bytes, past, kBlanks);
    if (ends_line(bytes, next)) return past;
    const std::string_view rest = bytes.substr(next);
    if (!rest.starts_with(kOpen)) return at;
    const std::size_t close = rest.find(kClose, kOpen.size());
    if (close == std::string_view::npos) return at;
    if (rest.substr(0, close).find('\n') != std::string_view::npos) return at;
    past = static_cast<std::uint32_t>(next + close + kClose.size());
  }
}

const Token& token_at(const Document& document, std::uint32_t at) {
  const auto behind = [](std::uint32_t place, const Token& token) { return place < token.begin; };
  const auto& tokens = document.tokens();
  return *std::prev(std::upper_bound(tokens.begin(), tokens.end(), at, behind));
}

bool may_edit(const Document& document, Element element) {
  return document.complete() && !element.cut();
}

/// Where the end tag begins, of an element that has one.
std::uint32_t end_tag(const Document& document, Element element) {
  return static_cast<std::uint32_t>(document.bytes().rfind('<', element.span().end - 1));
}

bool has_text(Element element) { return element.text_span().end > element.tag_span().end; }

Edit edit(const Document& document, std::uint32_t begin, std::uint32_t end, std::string text) {
  return {{document.source(), begin, end}, std::move(text)};
}

/// `<a/>` with something between a start tag and an end tag.
Edit filled(const Document& document, Element empty, const std::string& content) {
  const std::uint32_t end = empty.tag_span().end;
  return edit(document, skip_back(document.bytes(), end - 2, kSpace), end,
              '>' + content + "</" + std::string(empty.name()) + '>');
}

/// Each line of a snippet with its depth: calls `put(depth, line)`.
template <class Put>
void for_each_line(std::string_view snippet, Put put) {
  while (true) {
    const std::size_t end = snippet.find('\n');
    const std::string_view line = snippet.substr(0, end);
    const std::size_t spaces = std::min(line.find_first_not_of(' '), line.size());
    put(spaces / 2, line.substr(spaces));
    if (end == std::string_view::npos) return;
    snippet.remove_prefix(end + 1);
  }
}

/// A snippet's lines as they go near an element; before the first stands nothing.
std::string in_lines(const Document& document, Element near, std::string_view xml,
                     std::string_view indent, std::string_view end) {
  std::string result;
  const std::string unit = indent_unit(document, near);
  for_each_line(in_style(document, near, xml), [&](std::size_t depth, std::string_view line) {
    if (!result.empty()) result.append(end).append(indent);
    for (std::size_t level = 0; level < depth; ++level) result += unit;
    result += line;
  });
  return result;
}

std::string in_one_line(const Document& document, Element near, std::string_view xml,
                        std::string_view between) {
  std::string result;
  for_each_line(in_style(document, near, xml), [&](std::size_t, std::string_view line) {
    if (!result.empty()) result += between;
    result += line;
  });
  return result;
}

/// Puts new children into an element.
class Insertion {
 public:
  Insertion(const Document& document, Element parent, std::optional<Element> after,
            std::string_view xml)
      : document_(document), bytes_(document.bytes()), parent_(parent), after_(after), xml_(xml) {}

  Edit make() {
    if (is_empty_tag(document_, parent_)) return filled(document_, parent_, whole_content());
    begin_ = skip_comments(bytes_, behind());
    end_ = skip(bytes_, begin_, kSpace);
    if (gap().find('\n') != std::string_view::npos) return before_line_end();
    if (end_ == end_tag(document_, parent_)) {
      if (after_ && stands_first(document_, *after_)) {
        return edit_at(begin_, own_lines(line_end(document_, begin_)));
      }
      if (!after_ && !has_text(parent_)) return edit(document_, begin_, end_, whole_content());
    }
    const std::string between(separator());
    return edit_at(begin_, between + in_one_line(document_, parent_, xml_, between));
  }

 private:
  /// The white space that the children go into.
  std::string_view gap() const { return bytes_.substr(begin_, end_ - begin_); }

  Edit edit_at(std::uint32_t at, std::string text) const {
    return edit(document_, at, at, std::move(text));
  }

  /// What the children stand directly behind. Text stays in front of them: behind a child it would
  /// not be the parent's value any more.
  std::uint32_t behind() const {
    if (after_) return after_->span().end;
    if (!has_text(parent_)) return parent_.tag_span().end;
    return skip_back(bytes_, token_at(document_, parent_.text_span().begin).end, kSpace);
  }

  /// All that stands between a parent's tags, when that was nothing.
  std::string whole_content() const {
    if (!stands_first(document_, parent_)) return in_one_line(document_, parent_, xml_, {});
    const std::string_view end = line_end(document_, parent_.tag_span().end);
    return own_lines(end).append(end).append(indentation(document_, parent_));
  }

  /// Each with the line end before it.
  std::string own_lines(std::string_view end) const {
    const std::string indent = child_indentation();
    return std::string(end) + indent + in_lines(document_, parent_, xml_, indent, end);
  }

  Edit before_line_end() const {
    const std::size_t feed = bytes_.find('\n', begin_);
    const bool carriage = feed > begin_ && bytes_[feed - 1] == '\r';
    return edit_at(static_cast<std::uint32_t>(carriage ? feed - 1 : feed),
                   own_lines(carriage ? "\r\n" : "\n"));
  }

  std::string child_indentation() const {
    if (after_ && stands_first(document_, *after_)) return indentation(document_, *after_);
    for (const Element child : parent_.children()) {
      if (stands_first(document_, child)) return indentation(document_, child);
    }
    const std::size_t feed = gap().rfind('\n');
    if (feed != std::string_view::npos && end_ != end_tag(document_, parent_)) {
      return std::string(gap().substr(feed + 1));  // of a comment
    }
    return indentation(document_, parent_) + indent_unit(document_, parent_);
  }

  /// Between children that stand in one line.
  std::string_view separator() const {
    if (!after_) return has_text(parent_) ? std::string_view() : gap();
    const std::uint32_t begin = skip_back(bytes_, after_->span().begin, kSpace);
    const std::string_view before = bytes_.substr(begin, after_->span().begin - begin);
    return before.find('\n') == std::string_view::npos ? before : gap();
  }

  const Document& document_;
  std::string_view bytes_;
  Element parent_;
  std::optional<Element> after_;
  std::string_view xml_;
  std::uint32_t begin_ = 0;
  std::uint32_t end_ = 0;
};

/// From where on what stands before an element goes with it, inside a line.
std::uint32_t with_blanks(const Document& document, std::uint32_t begin) {
  const std::uint32_t from = skip_back(document.bytes(), begin, kSpace);
  return token_at(document, from).begin == from ? from : begin;  // else the end of a text
}

}  // namespace

std::vector<Edit> insert_child(const Document& document, Element parent,
                               std::optional<Element> after, std::string_view xml) {
  if (!may_edit(document, parent)) return {};
  return {Insertion(document, parent, after, xml).make()};
}

std::vector<Edit> replace_element(const Document& document, Element element, std::string_view xml) {
  if (!may_edit(document, element)) return {};
  const auto [source, begin, end] = element.span();
  const std::string text = stands_first(document, element)
                               ? in_lines(document, element, xml, indentation(document, element),
                                          line_end(document, begin))
                               : in_one_line(document, element, xml, {});
  return {edit(document, begin, end, text)};
}

std::vector<Edit> remove_element(const Document& document, Element element) {
  if (!may_edit(document, element) || !element.parent()) return {};
  const std::string_view bytes = document.bytes();
  const auto [source, begin, end] = element.span();
  if (!stands_first(document, element)) {
    return {edit(document, with_blanks(document, begin), end, {})};
  }
  const std::uint32_t next = skip(bytes, end, kBlanks);
  const auto indent = static_cast<std::uint32_t>(indentation(document, element).size());
  if (ends_line(bytes, next)) {
    const std::size_t past = std::min(bytes.find('\n', next), bytes.size() - 1) + 1;
    return {edit(document, begin - indent, static_cast<std::uint32_t>(past), {})};
  }
  if (next != end_tag(document, *element.parent())) return {edit(document, begin, next, {})};
  const std::uint32_t feed = begin - indent - 1;
  return {edit(document, feed - (bytes[feed - 1] == '\r' ? 1 : 0), end, {})};
}

std::vector<Edit> set_text(const Document& document, Element element, std::string_view text) {
  if (!may_edit(document, element)) return {};
  if (trimmed(element.text()) == text) return {};
  if (is_empty_tag(document, element)) return {filled(document, element, escaped(text))};

  const std::string_view bytes = document.bytes();
  const std::uint32_t tag_end = element.tag_span().end;
  if (!has_text(element)) {
    const std::uint32_t end = end_tag(document, element);
    const bool only_space = skip(bytes, tag_end, kSpace) == end;
    return {edit(document, tag_end, only_space ? end : tag_end, escaped(text))};
  }
  const Span span = element.text_span();
  const Token& token = token_at(document, span.begin);
  if (token.kind == TokenKind::kCData) {
    return {edit(document, token.begin, token.end, escaped(text))};
  }
  return {edit(document, skip(bytes, span.begin, kSpace), skip_back(bytes, span.end, kSpace),
               escaped(text))};
}

std::vector<Edit> set_attributes(const Document& document, Element element,
                                 const std::vector<NamedValue>& values) {
  if (!may_edit(document, element)) return {};
  const std::string_view bytes = document.bytes();
  std::uint32_t at = element.name_span().end;
  std::string separator = " ";
  char mark = quote(document, element);
  for (const Attribute attribute : element.attributes()) {
    const std::uint32_t name = attribute.name_span().begin;
    const std::uint32_t space = skip_back(bytes, name, kSpace);
    if (space < name) separator = bytes.substr(space, name - space);
    mark = bytes[attribute.value_span().end];
    at = attribute.span().end;
  }

  std::vector<Edit> edits;
  std::string added;
  for (const NamedValue& value : values) {
    const auto attribute = element.attribute(value.name);
    if (!attribute) {
      added += separator + std::string(value.name) + '=' + mark + escaped(value.value) + mark;
    } else if (attribute->value() != value.value) {
      edits.push_back({attribute->value_span(), escaped(value.value)});
    }
  }
  if (!added.empty()) edits.push_back(edit(document, at, at, added));
  return edits;
}

std::vector<Edit> set_attribute(const Document& document, Element element, std::string_view name,
                                std::string_view value) {
  return set_attributes(document, element, {{name, std::string(value)}});
}

std::vector<Edit> remove_attribute(const Document& document, Attribute attribute) {
  if (!document.complete()) return {};
  const std::string_view bytes = document.bytes();
  const std::uint32_t end = attribute.span().end;
  const std::uint32_t name = attribute.name_span().begin;
  // Where the next attribute touches this one, the white space before it is needed.
  const bool touched = std::string_view(" \t\r\n/>").find(bytes[end]) == std::string_view::npos;
  return {edit(document, touched ? name : skip_back(bytes, name, kSpace), end, {})};
}

std::vector<Edit> rename_element(const Document& document, Element element, std::string_view name) {
  if (!may_edit(document, element) || element.name() == name) return {};
  std::vector<Edit> edits{{element.name_span(), std::string(name)}};
  if (!is_empty_tag(document, element)) {
    const std::uint32_t begin = end_tag(document, element) + 2;
    const auto size = static_cast<std::uint32_t>(element.name().size());
    edits.push_back(edit(document, begin, begin + size, std::string(name)));
  }
  return edits;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&apos;"; break;
      default: result += c;
    }
  }
  return result;
}

}  // namespace rigor::xml
