// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/formatted.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <rigor/author/format/layout.h>
#include <rigor/author/format/same_content.h>
#include <rigor/text/sources.h>

namespace rigor::author {
namespace {

/// Faults that keep a strict parser from the file are for `validate` to report; these leave no structure to keep.
std::string why_refused(const xml::Document& document) {
  if (!document.complete()) return "it is not well-formed XML";
  for (const xml::Fault& fault : document.faults()) {
    if (fault.kind == xml::FaultKind::kTextOutsideRoot)
      return "it has text outside its root element";
    if (fault.kind == xml::FaultKind::kNotUtf8) return "it is not UTF-8";
  }
  return {};
}

Formatted proven(const xml::Document& document, std::vector<Edit> edits) {
  Formatted result{.edits = std::move(edits)};
  if (result.edits.empty()) {
    result.text = document.bytes();
    return result;
  }
  std::optional<std::string> text = apply_edits(document.bytes(), result.edits);
  if (!text || !same_content(document, xml::parse_own(*text, document.source()))) {
    return {.outcome = FormatOutcome::kWouldDiffer,
            .refused = "formatted, it would read otherwise: this is a fault of rigor"};
  }
  result.text = *std::move(text);
  return result;
}

}  // namespace

Formatted formatted(const xml::Document& document, const FormatStyle& style) {
  if (std::string why = why_refused(document); !why.empty())
    return {.outcome = FormatOutcome::kUnreadable, .refused = std::move(why)};
  return proven(document, layout_edits(document, style));
}

Formatted formatted_in_lines(const xml::Document& document, const FormatStyle& style,
                             std::uint32_t first, std::uint32_t last) {
  if (std::string why = why_refused(document); !why.empty())
    return {.outcome = FormatOutcome::kUnreadable, .refused = std::move(why)};
  const LineTable lines(document.bytes());
  std::vector<Edit> edits = layout_edits(document, style);
  // White space in front of a piece is the piece's line.
  std::erase_if(edits, [&](const Edit& edit) {
    const std::size_t ink = document.bytes().find_first_not_of(" \t\r\n", edit.span.begin);
    const auto begin = static_cast<std::uint32_t>(std::min<std::size_t>(ink, edit.span.end));
    return lines.position(edit.span.end).line < first || lines.position(begin).line > last;
  });
  return proven(document, std::move(edits));
}

}  // namespace rigor::author
