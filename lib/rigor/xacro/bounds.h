// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an expansion may take at most, each with its reason, so that no file hangs the program or takes
// its memory. Real files stay below all of them by a factor of ten.
//
//   Options options;
//   options.bounds.steps = 100'000;  // a fuzzer is in more of a hurry

#pragma once

#include <cstdint>

namespace rigor::xacro {

struct Bounds {
  /// Bytes of one file. The largest xacro file known has 0.3 MB, the largest YAML file 0.1 MB.
  std::uint64_t file_bytes = std::uint64_t{16} << 20U;
  /// Files read. A mobile manipulator takes about 60.
  std::uint32_t files = 2'000;
  /// Includes within includes. Python's own recursion limit ends the reference at about 300.
  std::uint32_t include_depth = 100;
  /// Nested elements, macros and conditionals being expanded, on the stack of this thread. Recursive
  /// macros count to some hundred; Python ends the reference at about 330 calls of a macro by itself.
  std::uint32_t depth = 1'000;
  /// Nodes of the result, and what brought them. The largest robots have 30,000.
  std::uint32_t nodes = 1'000'000;
  /// Nodes expanded and operations evaluated together; a robot takes less than a million.
  std::uint64_t steps = 20'000'000;
  /// Bytes of all values of expressions, which live as long as the expansion.
  std::uint64_t memory = std::uint64_t{256} << 20U;
  /// Bytes of a text, and items of a list, that an expression makes.
  std::uint64_t text_bytes = std::uint64_t{16} << 20U;
  std::uint64_t items = 1'000'000;
  /// Findings that are kept; the rest is counted.
  std::uint32_t facts = 1'000;
};

/// Calls, includes and conditions that are shown with a finding, the innermost ones. Recursion may have a
/// thousand, and a finding at each level.
inline constexpr std::uint32_t kMaxShownFrames = 50;

/// Bits of a whole number: Python prints 4,300 digits at most, which are 14,285 bits. Multiplying two of
/// these takes under a millisecond.
inline constexpr std::uint32_t kMaxIntegerBits = 1U << 16U;

/// Digits that Python converts between a text and a whole number (`sys.int_info`).
inline constexpr std::uint32_t kMaxIntegerDigits = 4'300;

/// Levels of an expression: parentheses, operators, subscripts. Python's parser ends near 200 of them.
inline constexpr std::uint32_t kMaxExpressionDepth = 200;

/// Levels of lists in lists that are printed or compared; one that holds itself has no end.
inline constexpr std::uint32_t kMaxValueDepth = 200;

/// Bytes of an expression. The longest known has 900.
inline constexpr std::uint32_t kMaxExpressionBytes = 64U << 10U;

/// Parameters of a macro. The most known are 60.
inline constexpr std::uint32_t kMaxParameters = 1'000;

/// Properties in a row whose texts need the next one's value.
inline constexpr std::uint32_t kMaxLazyDepth = 150;

}  // namespace rigor::xacro
