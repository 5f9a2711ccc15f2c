// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole numbers as Python has them: as long as they need to be. Values that fit 64 bits are computed
// there; the rest is Boost's. Operations take values that are integral (`True` is 1) and return one, an
// error where the result would have more than `kMaxIntegerBits`.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

/// A number that 64 bits do not hold; Boost's header is in the .cc alone, since it takes seconds.
struct BigInteger {
  struct Number;
  explicit BigInteger(std::unique_ptr<const Number> n);
  BigInteger(BigInteger&&) noexcept;
  BigInteger& operator=(BigInteger&&) noexcept;
  ~BigInteger();
  std::size_t bytes() const;
  std::unique_ptr<const Number> number;
};

enum class IntegerOperation : std::uint8_t {
  kAdd,
  kSubtract,
  kMultiply,
  kFloorDivide,  ///< rounds down: -7 // 2 is -4. The divisor is not 0
  kModulo,       ///< has the divisor's sign: -7 % 3 is 2. The divisor is not 0
  kPower,        ///< the exponent is not negative
  kShiftLeft,    ///< the distance is not negative
  kShiftRight,
  kAnd,
  kOr,
  kXor,
};

Value integer_operation(Heap& heap, IntegerOperation operation, Value a, Value b);
Value negated_integer(Heap& heap, Value a);
/// -1, 0 or 1.
int compare_integers(Value a, Value b);
bool is_zero_integer(Value a);
bool is_negative_integer(Value a);

/// Nearest, ties to even; infinite past the largest double.
double integer_to_double(Value a);
/// a / b rounded once, as Python divides whole numbers; b is not 0.
double true_quotient(Value a, Value b);
/// -1, 0 or 1; `d` is no NaN.
int compare_integer_to_double(Value a, double d);
/// The whole part of a finite number.
Value integer_from_double(Heap& heap, double whole);

/// Decimal, or in base 2, 8 or 16 without a prefix; nothing when Python refuses to print as many digits.
std::optional<std::string> integer_to_text(Value a, int base = 10);
/// Of digits of a base, without a sign; an error when there are too many.
Value integer_from_digits(Heap& heap, std::string_view digits, int base);
/// The largest whole number whose square is not above `a`, which is not negative.
Value integer_square_root(Heap& heap, Value a);
std::uint64_t integer_bits(Value a);

}  // namespace rigor::xacro
