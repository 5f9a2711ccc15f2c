// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The proof of a formatter: two documents that a reader cannot tell apart.

#pragma once

#include <rigor/xml/document.h>

namespace rigor::author {

/// Whether both have the same elements, attributes and texts in the same order, where rows of numbers may be
/// spaced otherwise; the same comments and other markup, and the same content of each <plugin>, byte for byte.
/// White space between markup is passed over. A model is made of nothing else, so theirs are the same.
bool same_content(const xml::Document& a, const xml::Document& b);

}  // namespace rigor::author
