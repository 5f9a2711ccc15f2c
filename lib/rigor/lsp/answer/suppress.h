// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Comments that suppress a finding, as edits (rules/suppression.h says what they cover).

#pragma once

#include <string>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

/// Before the element that a place is in: for its start tag, or for all that it contains. Nothing where the
/// element is the root, which only a comment on the file covers.
std::vector<Edit> suppressed_here(const xml::Document& document, Span where,
                                  const std::string& rule);

/// Before the root element.
std::vector<Edit> suppressed_in_file(const xml::Document& document, const std::string& rule);

}  // namespace rigor::lsp
