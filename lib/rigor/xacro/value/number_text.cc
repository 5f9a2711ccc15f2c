// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/number_text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include <rigor/text/letter_case.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

bool is_ascii_digit(char c) { return c >= '0' && c <= '9'; }

std::string converted(double d, std::chars_format format, int digits) {
  // A double has up to 309 digits before the point and `digits` behind it.
  std::string text(static_cast<std::size_t>(digits) + 330, '\0');
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), d, format, digits);
  text.resize(error == std::errc() ? static_cast<std::size_t>(end - text.data()) : 0);
  return text;
}

std::string not_finite(double d) { return std::isnan(d) ? "nan" : d < 0 ? "-inf" : "inf"; }

/// Exponent of a text like "1.5e-07", and the text before it.
int split_exponent(std::string_view text, std::string_view& mantissa) {
  const std::size_t e = text.find('e');
  mantissa = text.substr(0, e);
  int exponent = 0;
  const std::size_t digits = e + (text[e + 1] == '+' ? 2 : 1);
  std::from_chars(text.data() + digits, text.data() + text.size(), exponent);
  return exponent;
}

/// Without the blanks around, with ASCII digits, and without `_`; nothing where `_` is not between
/// digits.
std::optional<std::string> plain_number(std::string_view text, std::string_view digits) {
  text = stripped(text);
  std::string plain;
  const auto is_digit = [digits](char c) {
    return digits.find(lower(c)) != std::string_view::npos;
  };
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '_') {
      if (plain.empty() || !is_digit(plain.back()) || at + 1 == text.size() ||
          text[at + 1] == '_') {
        return std::nullopt;
      }
      ++at;
      // What follows must be a digit, of any script.
      std::size_t next = at;
      const int value = decimal_value(next_code_point(text, next));
      if (value < 0 && !is_digit(text[at])) return std::nullopt;
      continue;
    }
    std::size_t next = at;
    const std::uint32_t code_point = next_code_point(text, next);
    if (code_point < 0x80) {
      plain += text[at];
    } else if (const int value = decimal_value(code_point); value >= 0) {
      plain += static_cast<char>('0' + value);
    } else {
      return std::nullopt;
    }
    at = next;
  }
  return plain;
}

}  // namespace

std::optional<NumberText> short_number_text(Value v) {
  NumberText text;
  char* const first = text.bytes.data();
  char* const end = first + text.bytes.size();
  char* last = first;
  if (v.is(Type::kInteger)) {
    last = std::to_chars(first, end, v.integer_).ptr;
  } else if (v.is(Type::kReal)) {
    // There the shortest digits are the exact ones before the point, too.
    constexpr double kSmallestFixed = 1e-4;
    constexpr double kLargestFixed = 1e15;
    const double size = std::abs(v.real_);
    if (v.real_ != 0 && !(size >= kSmallestFixed && size < kLargestFixed)) return std::nullopt;
    last = std::to_chars(first, end, v.real_, std::chars_format::fixed).ptr;
    if (std::find(first, last, '.') == last) {
      *last++ = '.';
      *last++ = '0';
    }
  } else {
    return std::nullopt;
  }
  text.size = static_cast<std::size_t>(last - first);
  return text;
}

std::string real_to_text(double d) {
  if (!std::isfinite(d)) return not_finite(d);
  if (const auto text = short_number_text(Value::real(d))) return std::string(text->view());
  std::array<char, 40> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), d, std::chars_format::scientific);
  if (error != std::errc()) return "nan";
  std::string_view mantissa;
  const int exponent =
      split_exponent({buffer.data(), static_cast<std::size_t>(end - buffer.data())}, mantissa);
  if (exponent < -4 || exponent >= 16) {
    std::string text(mantissa);
    text += exponent < 0 ? "e-" : "e+";
    if (std::abs(exponent) < 10) text += '0';
    return text + std::to_string(std::abs(exponent));
  }
  std::string digits;
  std::string text = mantissa.starts_with('-') ? "-" : "";
  for (const char c : mantissa) {
    if (is_ascii_digit(c)) digits += c;
  }
  if (exponent < 0) {
    return text + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  }
  const auto before = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= before)
    return text + digits + std::string(before - digits.size(), '0') + ".0";
  return text + digits.substr(0, before) + '.' + digits.substr(before);
}

std::string fixed_text(double d, int digits) {
  return std::isfinite(d) ? converted(d, std::chars_format::fixed, digits) : not_finite(d);
}

std::string exponent_text(double d, int digits) {
  return std::isfinite(d) ? converted(d, std::chars_format::scientific, digits) : not_finite(d);
}

std::string general_text(double d, int digits, TrailingZeros zeros) {
  if (!std::isfinite(d)) return not_finite(d);
  digits = std::max(digits, 1);
  const std::string scientific = exponent_text(d, digits - 1);
  std::string_view mantissa;
  const int exponent = split_exponent(scientific, mantissa);
  const bool fixed = exponent >= -4 && exponent < digits;
  std::string text = fixed ? fixed_text(d, digits - 1 - exponent) : std::string(mantissa);
  if (zeros == TrailingZeros::kDropped && text.find('.') != std::string::npos) {
    text.resize(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return fixed ? text : text + scientific.substr(mantissa.size());
}

std::optional<double> plain_real(std::string_view digits) {
  double d = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), d);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc()) return d;
  // Out of range: too large or too small, by where the first digit other than 0 is.
  std::int64_t exponent = 0;
  const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
  if (e < digits.size()) {
    const std::size_t begin = e + (digits[e + 1] == '+' ? 2 : 1);
    const auto parsed =
        std::from_chars(digits.data() + begin, digits.data() + digits.size(), exponent);
    if (parsed.ec != std::errc()) exponent = digits[begin] == '-' ? -1'000'000 : 1'000'000;
  }
  const std::size_t point = std::min(digits.find('.'), e);
  const std::size_t first = digits.find_first_of("123456789");
  const auto magnitude =
      static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) + exponent;
  return magnitude > 0 ? std::numeric_limits<double>::infinity() : 0.0;
}

std::optional<double> real_from_text(std::string_view text) {
  const std::optional<std::string> plain = plain_number(text, "0123456789");
  if (!plain) return std::nullopt;
  std::string_view rest = *plain;
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest.remove_prefix(1);
  if (rest.empty()) return std::nullopt;
  std::optional<double> d;
  if (is_ascii_digit(rest[0]) || rest[0] == '.') {
    d = plain_real(rest);
  } else {
    const std::string word = lowered(rest);
    if (word == "inf" || word == "infinity") d = std::numeric_limits<double>::infinity();
    if (word == "nan") d = std::numeric_limits<double>::quiet_NaN();
  }
  if (d && negative) d = -*d;
  return d;
}

Value plain_decimal(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::int64_t whole = 0;
  std::size_t at = 0;
  // More digits may not fit.
  constexpr std::size_t kMostDigits = 18;
  for (; at < text.size() && at < kMostDigits && is_ascii_digit(text[at]); ++at)
    whole = whole * 10 + (text[at] - '0');
  if (at == 0) return Value::error();
  if (at == text.size()) return Value::integer(negative ? -whole : whole);
  if (text[at] != '.' || at + 1 == text.size()) return Value::error();
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (!is_ascii_digit(text[i])) return Value::error();
  }
  double d = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), d);
  if (error != std::errc() || end != text.data() + text.size()) return Value::error();
  return Value::real(negative ? -d : d);
}

Value integer_from_text(Heap& heap, std::string_view text, int base) {
  std::optional<std::string> plain = plain_number(text, "0123456789abcdefghijklmnopqrstuvwxyz");
  if (!plain || base < 0 || base == 1 || base > 36) return Value::error();
  std::string_view rest = *plain;
  const bool negative = rest.starts_with('-');
  if (negative || rest.starts_with('+')) rest.remove_prefix(1);
  const auto prefix = [&rest](char letter) {
    return rest.size() > 2 && rest[0] == '0' && lower(rest[1]) == letter;
  };
  for (const auto& [letter, prefixed] : {std::pair{'x', 16}, {'o', 8}, {'b', 2}}) {
    if (!prefix(letter) || (base != prefixed && base != 0)) continue;
    base = prefixed;
    rest.remove_prefix(2);
    break;
  }
  if (base == 0) {
    // 007 is no number of Python's source, but 0 and 00 are.
    if (rest.starts_with('0') && rest.find_first_not_of('0') != std::string_view::npos) {
      return Value::error();
    }
    base = 10;
  }
  const bool all_digits = std::all_of(rest.begin(), rest.end(), [base](char c) {
    const int digit = is_ascii_digit(c)                    ? c - '0'
                      : lower(c) >= 'a' && lower(c) <= 'z' ? lower(c) - 'a' + 10
                                                           : 99;
    return digit < base;
  });
  if (rest.empty() || !all_digits) return Value::error();
  const Value n = integer_from_digits(heap, rest, base);
  return negative && !n.failed() ? negated_integer(heap, n) : n;
}

}  // namespace rigor::xacro
