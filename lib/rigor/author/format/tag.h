// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Start tags in one style: `<name a="1" b="2">`, or a line for each attribute where that is too long.

#pragma once

#include <string>
#include <string_view>

#include <rigor/author/format/format_style.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// Appends the element's start tag, or `<a/>` where it is written so. `indent` stands before it on its line;
/// `line_end` is what ends lines in the file.
void add_tag(std::string& text, const xml::Document& document, xml::Element element,
             const FormatStyle& style, std::string_view indent, std::string_view line_end);

}  // namespace rigor::author
