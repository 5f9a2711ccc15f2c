// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/formatted.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <rigor/author/format/layout.h>
#include <rigor/author/format/same_content.h>
#include <rigor/text/sources.h>

namespace rigor::author {
namespace {

/// The roots of models, and of what they include.
constexpr std::string_view kRoots[] = {"sdf",   "gazebo", "robot", "mujoco", "mujocoinclude",
                                       "model", "world",  "actor", "light",  "link"};

/// Of a launch file or a page white space may mean something; a template of xacro may begin with any element.
bool is_of_model(const xml::Element root) {
  return std::find(std::begin(kRoots), std::end(kRoots), root.name()) != std::end(kRoots) ||
         root.attribute("xmlns:xacro");
}

/// Faults that keep a strict parser from the file are for `validate` to report; these leave no structure to keep.
std::string why_refused(const xml::Document& document) {
  if (!document.complete()) return "it is not well-formed XML";
  for (const xml::Fault& fault : document.faults()) {
    if (fault.kind == xml::FaultKind::kTextOutsideRoot)
      return "it has text outside its root element";
    if (fault.kind == xml::FaultKind::kNotUtf8) return "it is not UTF-8";
  }
  const auto root = document.root();
  if (root && !is_of_model(*root))
    return "<" + std::string(root->name()) + "> is no robot model's root element";
  return {};
}

Formatted differing() {
  return {.outcome = FormatOutcome::kWouldDiffer,
          .refused = "formatted, it would read otherwise: this is a fault of rigor"};
}

/// What differs, as one edit.
Edit changed_range(const xml::Document& document, std::string_view text) {
  const std::string_view before = document.bytes();
  const std::size_t shorter = std::min(before.size(), text.size());
  std::size_t begin = 0;
  while (begin < shorter && before[begin] == text[begin]) ++begin;
  std::size_t end = 0;
  while (end < shorter - begin && before[before.size() - 1 - end] == text[text.size() - 1 - end])
    ++end;
  return {{document.source(), static_cast<std::uint32_t>(begin),
           static_cast<std::uint32_t>(before.size() - end)},
          std::string(text.substr(begin, text.size() - end - begin))};
}

Formatted proven(const xml::Document& document, std::vector<Edit> edits) {
  Formatted result{.edits = std::move(edits)};
  if (result.edits.empty()) {
    result.text = document.bytes();
    return result;
  }
  std::optional<std::string> text = apply_edits(document.bytes(), result.edits);
  if (!text || !same_content(document, xml::parse_own(*text, document.source())))
    return differing();
  result.text = *std::move(text);
  return result;
}

}  // namespace

Formatted formatted(const xml::Document& document, const FormatStyle& style) {
  if (std::string why = why_refused(document); !why.empty())
    return {.outcome = FormatOutcome::kUnreadable, .refused = std::move(why)};
  return proven(document, layout_edits(document, style));
}

Formatted formatted(const xml::Document& document, const FormatStyle& style,
                    const ChildOrder& order) {
  if (style.order == FormatOrder::kKeep || !why_refused(document).empty())
    return formatted(document, style);
  const std::string text = order.ordered(document);
  if (text == document.bytes()) return formatted(document, style);
  const xml::Document in_order = xml::parse_own(text, document.source());
  if (!same_but_for_order(document, in_order)) return differing();
  Formatted result = formatted(in_order, style);
  if (result.outcome != FormatOutcome::kDone) return result;
  result.edits = {changed_range(document, result.text)};
  return result;
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
