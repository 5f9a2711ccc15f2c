// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/tag.h>

#include <algorithm>
#include <cstddef>
#include <vector>

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

std::string attribute_text(const xml::Document& document, xml::Attribute attribute,
                           const FormatStyle& style) {
  const Span span = attribute.value_span();
  const std::string_view value = document.bytes().substr(span.begin, span.size());
  const char quote = quote_for(value, document.bytes()[span.begin - 1], style.quotes);
  std::string text(attribute.name());
  text += '=';
  text += quote;
  const auto row = is_row_attribute(attribute.name()) ? number_row(value) : std::nullopt;
  text += row ? std::string_view(*row) : value;
  text += quote;
  return text;
}

}  // namespace

std::string tag_text(const xml::Document& document, xml::Element element, const FormatStyle& style,
                     std::string_view indent, std::string_view line_end) {
  std::vector<std::string> attributes;
  for (const xml::Attribute attribute : element.attributes())
    attributes.push_back(attribute_text(document, attribute, style));
  const std::string_view close = xml::is_empty_tag(document, element) ? "/>" : ">";
  const std::string name = '<' + std::string(element.name());
  std::string line = name;
  for (const std::string& attribute : attributes) line += ' ' + attribute;
  line += close;
  // A value that runs over lines of its own is as wide as its first.
  const std::string_view first(line.data(), std::min(line.find('\n'), line.size()));
  if (attributes.size() < 2 || columns(indent) + columns(first) <= style.width) return line;
  std::string wrapped = name;
  for (const std::string& attribute : attributes) {
    wrapped += line_end;
    wrapped += indent;
    for (int level = 0; level < kAttributeLevels; ++level) wrapped += style.indent;
    wrapped += attribute;
  }
  wrapped += close;
  return wrapped;
}

std::string end_tag_text(xml::Element element) { return "</" + std::string(element.name()) + '>'; }

}  // namespace rigor::author
