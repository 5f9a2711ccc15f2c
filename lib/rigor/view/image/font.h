// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Letters as strokes, for captions: drawn at any size, with smooth edges.
//
//   const Letter r = letter('R');
//   for (const LetterSegment& segment : r.segments) draw(segment);
//   x += r.advance;

#pragma once

#include <string_view>
#include <vector>

namespace rigor::view {

/// Of lengths the unit is a tenth of the height of a capital. x goes to the right from the letter's left edge, y
/// up from the baseline.
struct LetterSegment {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Letter {
  std::vector<LetterSegment> segments;
  double advance = 0;  ///< to the left edge of the next letter
};

inline constexpr double kCapHeight = 10;
inline constexpr double kDescent = 4;      ///< of what hangs below the baseline
inline constexpr double kPenWidth = 1.25;  ///< of the strokes

/// What is no printable ASCII is a '?'.
Letter letter(char c);

/// The sum of the advances.
double text_width(std::string_view text);

}  // namespace rigor::view
