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
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

/// What is not as it is.
struct LayoutChanges {
  struct Replacement {
    Span where;  ///< of the text of an element without others in it, or of an attribute's value
    std::string text;  ///< escaped
  };
  std::optional<std::string>
      pose;  ///< takes the place of the element's `<pose>`, or is its first child
  std::vector<Replacement> replacements;
  std::vector<Span> removed;       ///< elements inside that are left out
  std::vector<std::string> added;  ///< elements that become its first children, a line each
};

/// Lines ended by '\n'.
std::string laid_out(const xml::Document& document, xml::Element element,
                     const LayoutChanges& changes = {});

}  // namespace rigor::convert
