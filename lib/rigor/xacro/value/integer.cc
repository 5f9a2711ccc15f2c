// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/integer.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>

#include <rigor/xacro/bounds.h>
#include <rigor/xacro/value/heap.h>

namespace rigor::xacro {

struct BigInteger::Number {
  boost::multiprecision::cpp_int value;
};

BigInteger::BigInteger(std::unique_ptr<const Number> n) : number(std::move(n)) {}
BigInteger::BigInteger(BigInteger&&) noexcept = default;
BigInteger& BigInteger::operator=(BigInteger&&) noexcept = default;
BigInteger::~BigInteger() = default;
std::size_t BigInteger::bytes() const { return number->value.backend().size() * sizeof(void*); }

namespace {

using boost::multiprecision::cpp_int;
constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

cpp_int wide(Value v) {
  return v.is(Type::kBigInteger) ? v.big_->number->value : cpp_int(v.integer_);
}

std::uint64_t bits_of(const cpp_int& n) {
  return n == 0 ? 0 : boost::multiprecision::msb(n < 0 ? cpp_int(-n) : n) + 1;
}

Value narrowed(Heap& heap, cpp_int n) {
  if (n >= kSmallest && n <= kLargest) return Value::integer(n.convert_to<std::int64_t>());
  if (bits_of(n) > kMaxIntegerBits) return Value::error();
  auto number = std::make_unique<BigInteger::Number>();
  number->value = std::move(n);
  return heap.big(BigInteger(std::move(number)));
}

std::optional<Value> small_operation(IntegerOperation operation, std::int64_t a, std::int64_t b) {
  std::int64_t r = 0;
  switch (operation) {
    case IntegerOperation::kAdd:
      if (__builtin_add_overflow(a, b, &r)) return std::nullopt;
      return Value::integer(r);
    case IntegerOperation::kSubtract:
      if (__builtin_sub_overflow(a, b, &r)) return std::nullopt;
      return Value::integer(r);
    case IntegerOperation::kMultiply:
      if (__builtin_mul_overflow(a, b, &r)) return std::nullopt;
      return Value::integer(r);
    case IntegerOperation::kFloorDivide:
      if (a == kSmallest && b == -1) return std::nullopt;
      r = a / b;
      if (a % b != 0 && (a < 0) != (b < 0)) --r;
      return Value::integer(r);
    case IntegerOperation::kModulo:
      if (b == -1) return Value::integer(0);
      r = a % b;
      if (r != 0 && (r < 0) != (b < 0)) r += b;
      return Value::integer(r);
    case IntegerOperation::kShiftRight: return Value::integer(a >> std::min<std::int64_t>(b, 63));
    case IntegerOperation::kAnd: return Value::integer(a & b);
    case IntegerOperation::kOr: return Value::integer(a | b);
    case IntegerOperation::kXor: return Value::integer(a ^ b);
    default: return std::nullopt;
  }
}

cpp_int floor_quotient(const cpp_int& a, const cpp_int& b) {
  cpp_int quotient;
  cpp_int remainder;
  boost::multiprecision::divide_qr(a, b, quotient, remainder);
  if (remainder != 0 && (remainder < 0) != (b < 0)) --quotient;
  return quotient;
}

/// a & b and such of numbers with signs, which Boost has for none: in two's complement.
cpp_int bitwise(IntegerOperation operation, const cpp_int& a, const cpp_int& b) {
  const auto bits = static_cast<unsigned>(std::max(bits_of(a), bits_of(b)) + 1);
  const cpp_int modulus = cpp_int(1) << bits;
  const cpp_int x = a < 0 ? cpp_int(a + modulus) : a;
  const cpp_int y = b < 0 ? cpp_int(b + modulus) : b;
  cpp_int r = operation == IntegerOperation::kAnd  ? cpp_int(x & y)
              : operation == IntegerOperation::kOr ? cpp_int(x | y)
                                                   : cpp_int(x ^ y);
  if (bit_test(r, bits - 1)) r -= modulus;
  return r;
}

/// n * 2^exponent as a double, ties to even; `sticky` when something below n was cut off.
double scaled(const cpp_int& n, std::int64_t exponent, bool sticky) {
  // Of more than 64 bits the low ones only say whether there is something.
  const std::uint64_t bits = bits_of(n);
  cpp_int top = n;
  if (bits > 64) {
    const auto cut = static_cast<unsigned>(bits - 64);
    top = n >> cut;
    sticky = sticky || (top << cut) != n;
    exponent += cut;
  }
  auto mantissa = top.convert_to<std::uint64_t>();
  if (mantissa == 0) return 0;
  const int spare = __builtin_clzll(mantissa);
  mantissa <<= spare;
  exponent -= spare;
  // 53 bits are kept, fewer of a subnormal number.
  std::int64_t dropped = 11;
  if (exponent + 64 < -1021) dropped += -1021 - (exponent + 64);
  if (dropped > 64) return 0;
  const std::uint64_t kept = dropped == 64 ? 0 : mantissa >> dropped;
  const std::uint64_t rest =
      dropped == 64 ? mantissa : mantissa & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  const bool up = rest > half || (rest == half && (sticky || (kept & 1U) != 0));
  if (exponent + dropped > 2000) return std::numeric_limits<double>::infinity();
  return std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), static_cast<int>(exponent + dropped));
}

}  // namespace

Value integer_operation(Heap& heap, IntegerOperation operation, Value a, Value b) {
  if (a.is_small() && b.is_small()) {
    if (const auto small = small_operation(operation, a.integer_, b.integer_)) return *small;
  }
  switch (operation) {
    case IntegerOperation::kAdd: return narrowed(heap, wide(a) + wide(b));
    case IntegerOperation::kSubtract: return narrowed(heap, wide(a) - wide(b));
    case IntegerOperation::kMultiply: return narrowed(heap, wide(a) * wide(b));
    case IntegerOperation::kFloorDivide: return narrowed(heap, floor_quotient(wide(a), wide(b)));
    case IntegerOperation::kModulo: {
      const cpp_int x = wide(a);
      const cpp_int y = wide(b);
      return narrowed(heap, x - floor_quotient(x, y) * y);
    }
    case IntegerOperation::kPower: {
      const cpp_int base = wide(a);
      if (base == 0 || base == 1) return Value::integer(is_zero_integer(b) ? 1 : a.integer_);
      if (base == -1) return Value::integer(bit_test(cpp_int(abs(wide(b))), 0) ? -1 : 1);
      // |base| is 2 at least, so the result has at least as many bits as the exponent says.
      if (!b.is_small() || b.integer_ > kMaxIntegerBits ||
          static_cast<std::uint64_t>(b.integer_) * (bits_of(base) - 1) > kMaxIntegerBits) {
        return Value::error();
      }
      return narrowed(heap, boost::multiprecision::pow(base, static_cast<unsigned>(b.integer_)));
    }
    case IntegerOperation::kShiftLeft: {
      if (is_zero_integer(a)) return Value::integer(0);
      if (!b.is_small() || b.integer_ > kMaxIntegerBits) return Value::error();
      return narrowed(heap, wide(a) << static_cast<unsigned>(b.integer_));
    }
    case IntegerOperation::kShiftRight: {
      if (!b.is_small() || b.integer_ > kMaxIntegerBits) {
        return Value::integer(is_negative_integer(a) ? -1 : 0);
      }
      return narrowed(heap,
                      floor_quotient(wide(a), cpp_int(1) << static_cast<unsigned>(b.integer_)));
    }
    default: return narrowed(heap, bitwise(operation, wide(a), wide(b)));
  }
}

Value negated_integer(Heap& heap, Value a) {
  return integer_operation(heap, IntegerOperation::kSubtract, Value::integer(0), a);
}

int compare_integers(Value a, Value b) {
  if (a.is_small() && b.is_small()) {
    return a.integer_ < b.integer_ ? -1 : a.integer_ > b.integer_ ? 1 : 0;
  }
  return wide(a).compare(wide(b));
}

bool is_zero_integer(Value a) { return a.is_small() && a.integer_ == 0; }

bool is_negative_integer(Value a) {
  return a.is(Type::kBigInteger) ? a.big_->number->value < 0 : a.integer_ < 0;
}

double integer_to_double(Value a) {
  if (a.is_small()) return static_cast<double>(a.integer_);
  const cpp_int& n = a.big_->number->value;
  return n < 0 ? -scaled(-n, 0, false) : scaled(n, 0, false);
}

double true_quotient(Value a, Value b) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53U;
  const auto exact = [](Value v) {
    return v.is_small() && v.integer_ <= kExact && v.integer_ >= -kExact;
  };
  if (exact(a) && exact(b))
    return static_cast<double>(a.integer_) / static_cast<double>(b.integer_);
  cpp_int x = wide(a);
  cpp_int y = wide(b);
  const bool negative = (x < 0) != (y < 0);
  if (x < 0) x = -x;
  if (y < 0) y = -y;
  if (x == 0) return negative ? -0.0 : 0.0;
  // Shifted so that the quotient has at least 66 bits; what remains only breaks ties.
  const auto shift = std::max<std::int64_t>(
      0, static_cast<std::int64_t>(bits_of(y)) - static_cast<std::int64_t>(bits_of(x)) + 66);
  cpp_int quotient;
  cpp_int remainder;
  boost::multiprecision::divide_qr(cpp_int(x << static_cast<unsigned>(shift)), y, quotient,
                                   remainder);
  const double result = scaled(quotient, -shift, remainder != 0);
  return negative ? -result : result;
}

int compare_integer_to_double(Value a, double d) {
  if (std::isinf(d)) return d > 0 ? -1 : 1;
  const double whole = std::floor(d);
  const cpp_int n = wide(a);
  const int order = n.compare(cpp_int(whole));
  if (order != 0) return order < 0 ? -1 : 1;
  return d > whole ? -1 : 0;
}

Value integer_from_double(Heap& heap, double whole) {
  if (std::abs(whole) < 9.2e18) return Value::integer(static_cast<std::int64_t>(whole));
  return narrowed(heap, cpp_int(whole));
}

std::optional<std::string> integer_to_text(Value a, int base) {
  const cpp_int n = wide(a);
  if (base == 10) {
    if (a.is_small()) return std::to_string(a.integer_);
    // log10(2) < 0.30103: fewer bits than these cannot have too many digits.
    if (bits_of(n) > kMaxIntegerDigits * 4U) return std::nullopt;
    std::string text = n.str();
    if (text.size() - (n < 0 ? 1 : 0) > kMaxIntegerDigits) return std::nullopt;
    return text;
  }
  const unsigned step = base == 2 ? 1 : base == 8 ? 3 : 4;
  std::string text;
  for (cpp_int left = abs(n); left != 0; left >>= step) {
    const auto digit = cpp_int(left & ((1U << step) - 1)).convert_to<unsigned>();
    text += "0123456789abcdef"[digit];
  }
  if (text.empty()) text = "0";
  if (n < 0) text += '-';
  std::reverse(text.begin(), text.end());
  return text;
}

Value integer_from_digits(Heap& heap, std::string_view digits, int base) {
  std::int64_t small = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), small, base);
  if (error == std::errc() && end == digits.data() + digits.size()) return Value::integer(small);
  if (digits.size() > (base == 10 ? kMaxIntegerDigits : kMaxIntegerBits)) return Value::error();
  cpp_int n = 0;
  for (const char c : digits) {
    const int digit = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
    n = n * base + digit;
  }
  return narrowed(heap, std::move(n));
}

Value integer_square_root(Heap& heap, Value a) {
  return narrowed(heap, boost::multiprecision::sqrt(wide(a)));
}

std::uint64_t integer_bits(Value a) { return bits_of(wide(a)); }

}  // namespace rigor::xacro
