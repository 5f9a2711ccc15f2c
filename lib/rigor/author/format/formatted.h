// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model file laid out anew: indentation, line breaks, spaces in tags, quotes, and rows of numbers on one
// line. What a reader of the file gets stays the same, and is compared before anybody may write the result.
//
//   const Formatted result = formatted(document, FormatStyle{});
//   if (result.refused.empty()) replace_file(path, result.text);
//
// Kept byte for byte: names, numbers, comments, CDATA, instructions, the content of <plugin>, content that
// mixes text and elements, and every text that is no row of numbers. Blank lines between elements stay, one
// of each run. Formatting what was formatted changes nothing.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/author/format/child_order.h>
#include <rigor/author/format/format_style.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

enum class FormatOutcome : std::uint8_t {
  kDone,
  kUnreadable,   ///< not well-formed, text stands outside the root element, or it is no robot model
  kWouldDiffer,  ///< the result would read otherwise: a fault of ours
};

struct Formatted {
  FormatOutcome outcome = FormatOutcome::kDone;
  std::vector<Edit> edits;  ///< in order; none where the file is formatted
  std::string text;         ///< the file with the edits done; empty where it is refused
  std::string refused;      ///< why the file stays as it is; empty where it does not
};

/// The order of children is kept, whatever the style asks for.
Formatted formatted(const xml::Document& document, const FormatStyle& style);

/// The same, with children in the order that the style asks for.
Formatted formatted(const xml::Document& document, const FormatStyle& style,
                    const ChildOrder& order);

/// As the first, of the lines `first` to `last` only (1-based, both included).
Formatted formatted_in_lines(const xml::Document& document, const FormatStyle& style,
                             std::uint32_t first, std::uint32_t last);

}  // namespace rigor::author
