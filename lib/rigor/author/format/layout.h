// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The edits that lay a document out. See formatted.h for what they keep.

#pragma once

#include <vector>

#include <rigor/author/format/format_style.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// In order, none of them without effect. The document is complete, with all of its text inside the root.
std::vector<Edit> layout_edits(const xml::Document& document, const FormatStyle& style);

}  // namespace rigor::author
