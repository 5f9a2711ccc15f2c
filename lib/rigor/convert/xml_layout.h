// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An element of a document as it is, laid out anew: two spaces a level, a line to each tag; an element
// that holds no other is one piece, whatever its text. Private to the room.
//
//   block.xml += laid_out(document, plugin);

#pragma once

#include <optional>
#include <string>

#include <rigor/xml/document.h>

namespace rigor::convert {

/// Lines ended by '\n'. Where there is a `pose`, it takes the place of the element's `<pose>`, or
/// becomes its first child.
std::string laid_out(const xml::Document& document, xml::Element element,
                     const std::optional<std::string>& pose = {});

}  // namespace rigor::convert
