// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor fmt` on a document, or on lines of it.

#include <rigor/author/format/formatted.h>
#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/edits_json.h>

namespace rigor::lsp {
namespace {

Json edits_of(const OpenDocument& document, const author::Formatted& formatted) {
  if (formatted.outcome != author::FormatOutcome::kDone)
    throw RequestError(ErrorCode::kRequestFailed,
                       "the document is not formatted: " + formatted.refused);
  return text_edits(document.lines(), formatted.edits);
}

/// What tinyxml2 refuses is not formatted, so it is asked here.
xml::Document judged(const OpenDocument& document) {
  return xml::parse(document.text(), SourceId{0});
}

}  // namespace

Json formatted_document(State& state, const Json& params) {
  const OpenDocument& document = state.document(params);
  const author::FormatStyle style = state.project->settings().layout(document.path());
  const author::ChildOrder order(state.environment().sdf, state.environment().urdf);
  return edits_of(document, author::formatted(judged(document), style, order));
}

Json formatted_range(State& state, const Json& params) {
  const OpenDocument& document = state.document(params);
  const author::FormatStyle style = state.project->settings().layout(document.path());
  const TextPosition begin =
      document.lines().position(offset_in(document, member(params, "range", "start")));
  const TextPosition end =
      document.lines().position(offset_in(document, member(params, "range", "end")));
  // A selection of whole lines ends at the begin of the next.
  const bool before_line = end.character == 0 && end.line > begin.line;
  const std::uint32_t last = before_line ? end.line - 1 : end.line;
  return edits_of(document,
                  author::formatted_in_lines(judged(document), style, begin.line + 1, last + 1));
}

}  // namespace rigor::lsp
