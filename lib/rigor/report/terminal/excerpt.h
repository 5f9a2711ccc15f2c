// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of a source with what is spoken of marked underneath:
//
//      |
//   12 |     <lower>1</lower>
//      |            ^
//   13 |     <upper>-1</upper>
//      |            -- the upper limit
//
// A span over several lines is marked on its first one, a long line is cut around the mark, and
// nothing in the source reaches the terminal as a command. The work for a mark does not grow with
// the length of its line.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigor/report/places.h>
#include <rigor/report/terminal/color.h>
#include <rigor/text/span.h>

namespace rigor::report {

struct Mark {
  Span where;
  char sign = '^';      ///< drawn under each column; an empty span gets one
  std::string message;  ///< beside the signs; may be empty
};

struct ExcerptStyle {
  std::size_t gutter = 1;  ///< digits of the largest line number of the report's block
  Color color = Color::kPlain;
  Paint paint = Paint::kError;  ///< of the first mark; the others are framework
};

/// Digits of the largest line number that the marks need.
std::size_t gutter_width(const std::vector<Mark>& marks, Places& places);

/// `marks` stand in one source; the first one is the subject. Ends with a line break.
std::string excerpt(const std::vector<Mark>& marks, Places& places, const ExcerptStyle& style);

}  // namespace rigor::report
