// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Start tags and end tags: edited together, and closed as they are typed.

#include <string>

#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>
#include <rigor/lsp/document/xml_cursor.h>

namespace rigor::lsp {
namespace {

/// The name in the end tag; nowhere for an element without one.
Span end_name(const xml::Document& document, xml::Element element) {
  if (element.cut() || element.span().end == element.tag_span().end) return {};
  const std::string_view bytes = document.bytes();
  const std::size_t begin = bytes.rfind("</", element.span().end - 1);
  if (begin == std::string_view::npos || begin < element.tag_span().end) return {};
  const auto first = static_cast<std::uint32_t>(begin + 2);
  return {document.source(), first, first + element.name_span().size()};
}

}  // namespace

Json linked_editing_ranges(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const xml::Document& written = document.analysis(state.environment()).written();
  const std::uint32_t offset = offset_in(document, member(params, "position"));
  const auto element = written.element_at(offset);
  if (!element) return nullptr;
  const Span end = end_name(written, *element);
  const Span begin = element->name_span();
  const auto holds = [offset](Span span) { return span.begin <= offset && offset <= span.end; };
  if (end.nowhere() || (!holds(begin) && !holds(end))) return nullptr;
  return {{"ranges", {range_json(document.lines(), begin), range_json(document.lines(), end)}},
          {"wordPattern", "[\\w:.-]+"}};
}

/// After `>` the end tag, where the element has none yet; after `</` the name of the element to close.
Json typed_edits(State& state, const Json& params) {
  OpenDocument& document = state.document(params);
  const std::uint32_t offset = offset_in(document, member(params, "position"));
  const std::string_view before = std::string_view(document.text()).substr(0, offset);
  const std::string typed = text_at(params, "ch");
  Json edits = Json::array();
  const auto insert = [&](const std::string& text) {
    edits.push_back({{"range", range_json(document.lines(), offset, offset)}, {"newText", text}});
  };
  const XmlCursor cursor = xml_cursor(document.text(), offset);
  if (cursor.open.empty()) return edits;
  const std::string name(cursor.open.back().name);
  if (typed == "/" && cursor.at == XmlCursor::At::kEndTagName && cursor.typed.empty()) {
    insert(name + '>');
  } else if (typed == ">" && cursor.at == XmlCursor::At::kText && cursor.typed.empty() &&
             !before.ends_with("/>") && before.substr(before.rfind('<')).starts_with('<' + name)) {
    const XmlCursor whole =
        xml_cursor(document.text(), static_cast<std::uint32_t>(document.text().size()));
    const bool is_open_at_end = whole.open.size() >= cursor.open.size() ||
                                !document.analysis(state.environment()).written().complete();
    if (is_open_at_end) insert("</" + name + '>');
  }
  return edits;
}

}  // namespace rigor::lsp
