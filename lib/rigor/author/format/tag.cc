// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/tag.h>

#include <cstddef>

#include <rigor/author/format/number_row.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

/// Levels that attributes on lines of their own are deeper than their tag, so that they are not taken for children.
constexpr int kAttributeLevels = 2;

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
    count += c == '\t' ? kTabColumns : continues ? 0 : 1;
  }
  return count;
}

char quote_for(std::string_view value, char written, FormatQuotes wanted) {
  const char quote = wanted == FormatQuotes::kKeep     ? written
                     : wanted == FormatQuotes::kDouble ? '"'
                                                       : '\'';
  return value.find(quote) == std::string_view::npos ? quote : written;
}

void add_attribute(std::string& text, const xml::Document& document, xml::Attribute attribute,
                   const FormatStyle& style) {
  const Span span = attribute.value_span();
  const std::string_view value = document.bytes().substr(span.begin, span.size());
  const char quote = quote_for(value, document.bytes()[span.begin - 1], style.quotes);
  text += attribute.name();
  text += '=';
  text += quote;
  const auto row = is_row_attribute(attribute.name()) ? number_row(value) : std::nullopt;
  text += row ? std::string_view(*row) : value;
  text += quote;
}

}  // namespace

void add_tag(std::string& text, const xml::Document& document, xml::Element element,
             const FormatStyle& style, std::string_view indent, std::string_view line_end) {
  const std::size_t begin = text.size();
  const std::string_view close = xml::is_empty_tag(document, element) ? "/>" : ">";
  text += '<';
  text += element.name();
  const std::size_t name_end = text.size();
  std::size_t attributes = 0;
  for (const xml::Attribute attribute : element.attributes()) {
    text += ' ';
    add_attribute(text, document, attribute, style);
    ++attributes;
  }
  text += close;
  if (attributes < 2) return;
  // A value that runs over lines of its own is as wide as its first.
  const std::string_view line = std::string_view(text).substr(begin);
  if (columns(indent) + columns(line.substr(0, line.find('\n'))) <= style.width) return;
  text.resize(name_end);
  for (const xml::Attribute attribute : element.attributes()) {
    text += line_end;
    text += indent;
    for (int level = 0; level < kAttributeLevels; ++level) text += style.indent;
    add_attribute(text, document, attribute, style);
  }
  text += close;
}

}  // namespace rigor::author
