// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers to text and back, as Python does: whatever the locale, shortest round trip, exponents from
// 1e16 and below 1e-4.
//
//   real_to_text(2.0);     // "2.0"
//   real_to_text(1e-5);    // "1e-05"
//   real_from_text(" .5 ");  // 0.5

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

/// `repr(d)`.
std::string real_to_text(double d);

/// The same of most numbers, without memory of its own.
struct NumberText {
  std::array<char, 40> bytes;
  std::size_t size = 0;

  std::string_view view() const { return {bytes.data(), size}; }
};
/// Of a whole number that fits 64 bits, and a real that prints without an exponent.
std::optional<NumberText> short_number_text(Value v);

/// As `%.Nf`, `%.Ne`, `%.Ng` of Python, for a number that is not negative; `g` drops trailing zeros.
std::string fixed_text(double d, int digits);
std::string exponent_text(double d, int digits);
enum class TrailingZeros { kDropped, kKept };
std::string general_text(double d, int digits, TrailingZeros zeros = TrailingZeros::kDropped);

/// `float(text)`: blanks around, a sign, digits of any script with single `_` between them, an exponent,
/// "inf", "nan". Nothing when it is none.
std::optional<double> real_from_text(std::string_view text);

/// `int(text, base)`: blanks around, a sign, digits with single `_` between them, for base 0, 2, 8 and 16
/// a prefix. An error value when it is none.
Value integer_from_text(Heap& heap, std::string_view text, int base = 10);

/// Of a sign and ASCII digits with a point among them or none, as nearly all numbers are written; an error value
/// of all else.
Value plain_decimal(std::string_view text);

/// Of plain ASCII as in `1.5e3`; nothing when it is none.
std::optional<double> plain_real(std::string_view digits);

}  // namespace rigor::xacro
