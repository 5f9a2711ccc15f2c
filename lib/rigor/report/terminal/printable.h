// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Text out of a file made fit for a terminal: what would move the cursor, color the screen or turn
// the reading direction is shown as a sign instead. A hostile file must not drive who reads about it.
//
//   out += printable(diagnostic.message);  // one line, whatever it holds

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor::report {

/// One character of a text.
struct Glyph {
  std::uint32_t size;  ///< in bytes of the text
  std::string shown;   ///< itself, or the sign that represents it; one column wide, never empty
};

/// The first character of `text`, which is not empty. A byte that is not part of UTF-8 is one.
Glyph first_glyph(std::string_view text);

/// The text on one line: line breaks, with the blanks after them, and tabs become a space.
std::string printable(std::string_view text);

/// The same, and not longer than `limit` characters; what is left out is counted.
std::string printable(std::string_view text, std::size_t limit);

}  // namespace rigor::report
