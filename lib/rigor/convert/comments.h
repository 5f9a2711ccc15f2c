// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an author wrote in front of an element. Private to the room.
//
//   link.comments = comments_before(document, element);

#pragma once

#include <string>
#include <vector>

#include <rigor/xml/document.h>

namespace rigor::convert {

/// What stands between `<!--` and `-->` of the comments that have nothing but white space between them
/// and the element, in the order of the file. One that ends a line with other markup before it belongs
/// to that.
std::vector<std::string> comments_before(const xml::Document& document, xml::Element element);

}  // namespace rigor::convert
