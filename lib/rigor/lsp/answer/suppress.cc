// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/answer/suppress.h>

#include <optional>
#include <string_view>

namespace rigor::lsp {
namespace {

/// A line of its own with the element's indentation; before the element where it does not begin its line.
std::vector<Edit> comment_before(const xml::Document& document, xml::Element element,
                                 const std::string& text) {
  const std::string_view bytes = document.bytes();
  const std::uint32_t begin = element.span().begin;
  std::uint32_t line = begin;
  while (line > 0 && (bytes[line - 1] == ' ' || bytes[line - 1] == '\t')) --line;
  const bool begins_line = line == 0 || bytes[line - 1] == '\n';
  const std::string comment = "<!-- rigor: " + text + " -->";
  if (!begins_line) return {{{document.source(), begin, begin}, comment}};
  const bool carriage_return = line > 1 && bytes[line - 2] == '\r';
  const std::string indent(bytes.substr(line, begin - line));
  return {
      {{document.source(), begin, begin}, comment + (carriage_return ? "\r\n" : "\n") + indent}};
}

}  // namespace

std::vector<Edit> suppressed_here(const xml::Document& document, Span where,
                                  const std::string& rule) {
  const auto element = document.element_at(where.begin);
  if (!element || !element->parent()) return {};
  const bool in_tag = where.end <= element->tag_span().end;
  return comment_before(document, *element, (in_tag ? "ignore-next[" : "ignore[") + rule + ']');
}

std::vector<Edit> suppressed_in_file(const xml::Document& document, const std::string& rule) {
  const auto root = document.root();
  if (!root) return {};
  return comment_before(document, *root, "file-ignore[" + rule + ']');
}

}  // namespace rigor::lsp
