// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/style.h>

#include <optional>
#include <utility>
#include <vector>

#include <rigor/text/byte_order_mark.h>
#include <rigor/text/edit.h>

namespace rigor::xml {
namespace {

std::size_t line_begin(std::string_view bytes, std::size_t at) {
  const std::size_t found = at == 0 ? std::string_view::npos : bytes.rfind('\n', at - 1);
  if (found != std::string_view::npos) return found + 1;
  return bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

/// What `probe` finds first: in `near` and what it holds, then in its parent's elements, then further
/// out. No element is examined twice.
template <class Probe>
auto nearest(const Document& document, Element near, Probe probe) -> decltype(probe(near)) {
  std::uint32_t first = near.index();  // of those that were examined
  std::uint32_t last = first;          // past them
  for (std::optional<Element> around = near; around; around = around->parent()) {
    for (std::uint32_t i = around->index(); i < first; ++i) {
      if (auto found = probe(document.element(i))) return found;
    }
    first = around->index();
    while (last < document.element_count() &&
           document.element(last).tag_span().begin < around->span().end) {
      if (auto found = probe(document.element(last++))) return found;
    }
  }
  return {};
}

/// What the indentation of its first child on a line of its own has more than the element's.
std::optional<std::string> deeper(const Document& document, Element element) {
  if (!stands_first(document, element)) return std::nullopt;
  const std::string outer = indentation(document, element);
  for (const Element child : element.children()) {
    if (!stands_first(document, child)) continue;
    const std::string inner = indentation(document, child);
    if (inner.size() <= outer.size() || !inner.starts_with(outer)) return std::nullopt;
    return inner.substr(outer.size());
  }
  return std::nullopt;
}

/// Where the white space before an empty tag's "/>" begins.
std::uint32_t end_of_content(const Document& document, Element empty) {
  const Span tag = empty.tag_span();
  const std::string_view text = document.bytes().substr(tag.begin, tag.size() - 2);
  return tag.begin + static_cast<std::uint32_t>(text.find_last_not_of(" \t\r\n") + 1);
}

}  // namespace

std::string indentation(const Document& document, Element element) {
  const std::string_view bytes = document.bytes();
  const std::size_t begin = line_begin(bytes, element.span().begin);
  const std::string_view line = bytes.substr(begin, element.span().begin - begin);
  return std::string(line.substr(0, line.find_first_not_of(kBlanks)));
}

bool stands_first(const Document& document, Element element) {
  // Back over blanks only: a line may hold all of a large file.
  const std::string_view bytes = document.bytes();
  const std::string_view before = bytes.substr(0, element.span().begin);
  const std::size_t past = before.find_last_not_of(kBlanks) + 1;
  return past == 0 || bytes[past - 1] == '\n' || before.substr(0, past) == kByteOrderMark;
}

bool is_empty_tag(const Document& document, Element element) {
  return document.bytes()[element.tag_span().end - 2] == '/';
}

std::string indent_unit(const Document& document, Element near) {
  return nearest(document, near, [&](Element element) { return deeper(document, element); })
      .value_or("  ");
}

std::string_view line_end(const Document& document, std::uint32_t at) {
  const std::string_view bytes = document.bytes();
  std::size_t found = bytes.find('\n', at);
  if (found == std::string_view::npos) found = bytes.rfind('\n');
  const bool carriage = found != std::string_view::npos && found > 0 && bytes[found - 1] == '\r';
  return carriage ? "\r\n" : "\n";
}

char quote(const Document& document, Element near) {
  const auto probe = [&](Element element) -> std::optional<char> {
    if (element.attributes().empty()) return std::nullopt;
    return document.bytes()[(*element.attributes().begin()).value_span().end];
  };
  return nearest(document, near, probe).value_or('"');
}

std::string_view self_close(const Document& document, Element near) {
  const auto probe = [&](Element element) -> std::optional<bool> {
    if (!is_empty_tag(document, element)) return std::nullopt;
    return end_of_content(document, element) + 2 < element.tag_span().end;
  };
  return nearest(document, near, probe).value_or(false) ? " />" : "/>";
}

std::string in_style(const Document& document, Element near, std::string_view xml) {
  const Document snippet = parse_own(xml, document.source());
  std::vector<Edit> edits;
  const auto replace = [&](std::uint32_t begin, std::uint32_t end, std::string text) {
    edits.push_back({{document.source(), begin, end}, std::move(text)});
  };
  for (std::uint32_t i = 0; i < snippet.element_count(); ++i) {
    const Element element = snippet.element(i);
    for (const Attribute attribute : element.attributes()) {
      const Span value = attribute.value_span();
      const char mark = quote(document, near);
      if (xml.substr(value.begin, value.size()).find(mark) != std::string_view::npos) continue;
      replace(value.begin - 1, value.begin, {mark});
      replace(value.end, value.end + 1, {mark});
    }
    if (is_empty_tag(snippet, element)) {
      replace(end_of_content(snippet, element), element.tag_span().end,
              std::string(self_close(document, near)));
    }
  }
  return apply_edits(xml, std::move(edits)).value_or(std::string(xml));
}

}  // namespace rigor::xml
