// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/value.h>

#include <cfloat>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <system_error>
#include <type_traits>

#include <rigor/text/letter_case.h>

namespace rigor::schema {
namespace {

using FaultKind = ValueFault::Kind;

// A part of a text, by offsets, so that a fault can say where it is.
struct Token {
  std::size_t begin, end;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

Token trim(std::string_view text) {
  Token token{0, text.size()};
  while (token.begin < token.end && is_space(text[token.begin])) ++token.begin;
  while (token.begin < token.end && is_space(text[token.end - 1])) --token.end;
  return token;
}

std::size_t skip_space(std::string_view text, std::size_t from) {
  while (from < text.size() && is_space(text[from])) ++from;
  return from;
}

// The next word at or after `from`; empty at the end of the text.
Token next_token(std::string_view text, std::size_t from) {
  from = skip_space(text, from);
  Token token{from, from};
  while (token.end < text.size() && !is_space(text[token.end])) ++token.end;
  return token;
}

ValueFault fault(FaultKind kind, Token token) { return {kind, token.begin, token.end}; }

// What follows a number at `at`, inside its token: a decimal comma or other text.
ValueFault trailing(std::string_view text, Token token, std::size_t at) {
  const bool comma = text[at] == ',' && at + 1 < token.end && is_digit(text[at + 1]);
  if (comma) return fault(FaultKind::kDecimalComma, token);
  return {FaultKind::kTrailingText, at, token.end};
}

// A number that from_chars calls out of range is too small, rather than too large, when its first
// digit that is not zero stands behind the point, exponent counted. Decimal exponents are clamped:
// "1e-99999999999" must not overflow.
bool is_below_range(std::string_view digits, bool hexadecimal) {
  constexpr long kFar = 1'000'000'000;
  long place = 0;  // of the first digit that is not zero; positive when before the point
  bool point = false, found = false;
  std::size_t i = 0;
  for (; i < digits.size(); ++i) {
    const char c = lower(digits[i]);
    if (c == (hexadecimal ? 'p' : 'e')) break;
    if (c == '.') {
      point = true;
    } else if (c != '0' && !found) {
      found = true;
      if (!point) place = 1;
    } else if (found && !point) {
      ++place;
    } else if (!found && point) {
      --place;
    }
  }
  long exponent = 0;
  if (i < digits.size()) {
    std::string_view written = digits.substr(i + 1);
    const bool negative = written.starts_with('-');
    if (negative || written.starts_with('+')) written.remove_prefix(1);
    for (const char c : written) {
      if (!is_digit(c)) break;
      if (exponent < kFar) exponent = exponent * 10 + (c - '0');
    }
    if (negative) exponent = -exponent;
  }
  return place * (hexadecimal ? 4 : 1) + exponent <= 0;
}

// A sign and 0x are taken off here: from_chars knows neither + nor the prefix.
struct Unsigned {
  std::size_t begin;
  bool negative, hexadecimal;
};

Unsigned take_prefix(std::string_view text, Token token) {
  Unsigned number{token.begin, false, false};
  if (number.begin < token.end && (text[number.begin] == '+' || text[number.begin] == '-')) {
    number.negative = text[number.begin] == '-';
    ++number.begin;
  }
  if (number.begin + 2 < token.end && text[number.begin] == '0' &&
      lower(text[number.begin + 1]) == 'x') {
    number.hexadecimal = true;
    number.begin += 2;
  }
  return number;
}

constexpr std::ptrdiff_t kMaxDigits = 15;  // 10^15 is below 2^53
constexpr std::array<double, kMaxDigits + 1> kPowersOfTen = {
    1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

// A plain decimal of few digits, as nearly every number of a model is; nothing for any other. Its
// digits and the power of ten are both exact doubles, so that their quotient is the nearest double
// to the number (Clinger 1990, "How to read floating point numbers accurately"), where doubles are
// computed as such.
std::optional<double> read_short_decimal(const char* first, const char* last) {
  if (FLT_EVAL_METHOD != 0 || last - first > kMaxDigits) return std::nullopt;
  std::int64_t digits = 0;
  const char* point = nullptr;
  for (const char* at = first; at != last; ++at) {
    if (is_digit(*at)) {
      digits = digits * 10 + (*at - '0');
    } else if (*at == '.' && point == nullptr && last - first > 1) {
      point = at;
    } else {
      return std::nullopt;
    }
  }
  const std::ptrdiff_t decimals = point != nullptr ? last - point - 1 : 0;
  return static_cast<double>(digits) / kPowersOfTen[static_cast<std::size_t>(decimals)];
}

// How many plain decimals of few digits a text holds, and nothing else: finite numbers that need not be
// computed to be taken. Nothing when there is any other word, which may be a number all the same.
std::optional<std::size_t> count_short_decimals(std::string_view text) {
  std::size_t count = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;; ++count) {
    while (at != end && is_space(*at)) ++at;
    if (at == end) return count;
    if (*at == '-' || *at == '+') ++at;
    const char* const first = at;
    while (at != end && is_digit(*at)) ++at;
    std::ptrdiff_t digits = at - first;
    if (at != end && *at == '.') {
      const char* const point = at++;
      while (at != end && is_digit(*at)) ++at;
      digits += at - point - 1;
    }
    if (digits == 0 || digits > kMaxDigits || (at != end && !is_space(*at))) return std::nullopt;
  }
}

template <class Real>
Parsed<Real> read_real(std::string_view text, Token token) {
  const Unsigned number = take_prefix(text, token);
  const char* const first = text.data() + number.begin;
  const char* const last = text.data() + token.end;
  // a second sign is not a number, though from_chars would take a minus
  if (first == last || *first == '-') return fault(FaultKind::kNotANumber, token);
  if (std::is_same_v<Real, double> && !number.hexadecimal) {
    if (const auto plain = read_short_decimal(first, last)) {
      return static_cast<Real>(number.negative ? -*plain : *plain);
    }
  }
  Real value = 0;
  const std::from_chars_result read = std::from_chars(
      first, last, value, number.hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (read.ec == std::errc::invalid_argument) return fault(FaultKind::kNotANumber, token);
  if (read.ptr != last) {
    return trailing(text, token, static_cast<std::size_t>(read.ptr - text.data()));
  }
  if (read.ec == std::errc::result_out_of_range) {
    const std::string_view digits(first, static_cast<std::size_t>(last - first));
    const bool below = is_below_range(digits, number.hexadecimal);
    return fault(below ? FaultKind::kUnderflow : FaultKind::kOutOfRange, token);
  }
  return number.negative ? -value : value;
}

Parsed<double> read_finite(std::string_view text, Token token) {
  const Parsed<double> parsed = read_real<double>(text, token);
  const double* const value = std::get_if<double>(&parsed);
  if (value && !std::isfinite(*value)) return fault(FaultKind::kNotFinite, token);
  return parsed;
}

template <class Integer>
Parsed<Integer> read_integer(std::string_view text, Token token) {
  constexpr bool kSigned = std::numeric_limits<Integer>::is_signed;
  const Unsigned number = take_prefix(text, token);
  const char* const first = text.data() + number.begin;
  const char* const last = text.data() + token.end;
  std::uint64_t magnitude = 0;
  const std::from_chars_result read =
      std::from_chars(first, last, magnitude, number.hexadecimal ? 16 : 10);
  if (read.ec == std::errc::invalid_argument) return fault(FaultKind::kNotANumber, token);
  if (read.ptr != last) {
    return trailing(text, token, static_cast<std::size_t>(read.ptr - text.data()));
  }
  if (number.negative && !kSigned) return fault(FaultKind::kNegative, token);
  const auto largest = static_cast<std::uint64_t>(std::numeric_limits<Integer>::max());
  const std::uint64_t limit = largest + (number.negative ? 1 : 0);
  if (read.ec == std::errc::result_out_of_range || magnitude > limit) {
    return fault(FaultKind::kOutOfRange, token);
  }
  // two's complement, so that the least integer, whose magnitude has no positive twin, comes out
  // right
  return static_cast<Integer>(number.negative ? ~magnitude + 1 : magnitude);
}

// Reads at least `least` values, each with `read(text, token)`, and at most as many as `values`
// takes; how many there were, or a fault.
template <class Value, class Read>
Parsed<std::size_t> read_list(std::string_view text, std::size_t least, std::span<Value> values,
                              Read read) {
  const Token whole = trim(text);
  if (whole.begin == whole.end) return ValueFault{FaultKind::kEmpty, 0, text.size()};
  std::size_t count = 0;
  std::size_t at = whole.begin;
  while (at < whole.end) {
    const Token token = next_token(text, at);
    if (count == values.size()) return ValueFault{FaultKind::kTooMany, token.begin, whole.end};
    const auto parsed = read(text, token);
    if (const ValueFault* found = std::get_if<ValueFault>(&parsed)) return *found;
    values[count++] = std::get<0>(parsed);
    at = skip_space(text, token.end);
  }
  if (count < least) return fault(FaultKind::kTooFew, whole);
  return count;
}

template <class Value, std::size_t Count, class Read>
Parsed<std::array<Value, Count>> read_array(std::string_view text, Read read) {
  std::array<Value, Count> values{};
  const Parsed<std::size_t> count = read_list(text, Count, std::span<Value>(values), read);
  if (const ValueFault* found = std::get_if<ValueFault>(&count)) return *found;
  return values;
}

// The text as one value: trimmed, not empty.
template <class Value, class Read>
Parsed<Value> read_one(std::string_view text, Read read) {
  const Token whole = trim(text);
  if (whole.begin == whole.end) return ValueFault{FaultKind::kEmpty, 0, text.size()};
  const Token token = next_token(text, whole.begin);
  Parsed<Value> parsed = read(text, token);
  if (token.end != whole.end && std::holds_alternative<Value>(parsed)) {
    const std::size_t surplus = next_token(text, token.end).begin;
    // "1.5 kg" has text behind the number, "1 2" has a number too many
    const Parsed<double> number = read_real<double>(text, next_token(text, surplus));
    const bool is_number = std::holds_alternative<double>(number);
    return ValueFault{is_number ? FaultKind::kTooMany : FaultKind::kTrailingText, surplus,
                      whole.end};
  }
  return parsed;
}

// How many numbers a value has, of a type that takes any that are finite; else 0.
std::size_t reals_of(Type type, RotationFormat format) {
  switch (type) {
    case Type::kDouble:
    case Type::kFloat:
    case Type::kAngle: return 1;
    case Type::kVector2: return 2;
    case Type::kVector3:
    case Type::kQuaternion: return 3;
    case Type::kPose: return format == RotationFormat::kQuatXyzw ? 7 : 6;
    default: return 0;
  }
}

template <class Value>
std::optional<ValueFault> fault_of(const Parsed<Value>& parsed) {
  const ValueFault* const found = std::get_if<ValueFault>(&parsed);
  return found ? std::optional(*found) : std::nullopt;
}

}  // namespace

Parsed<bool> parse_bool(std::string_view text) {
  const Token whole = trim(text);
  if (whole.begin == whole.end) return ValueFault{FaultKind::kEmpty, 0, text.size()};
  const std::string_view word = text.substr(whole.begin, whole.end - whole.begin);
  if (word == "1" || equal_but_for_case(word, "true")) return true;
  if (word == "0" || equal_but_for_case(word, "false")) return false;
  return fault(FaultKind::kBadBool, whole);
}

Parsed<std::int32_t> parse_int(std::string_view text) {
  return read_one<std::int32_t>(text, read_integer<std::int32_t>);
}

Parsed<std::uint32_t> parse_uint(std::string_view text) {
  return read_one<std::uint32_t>(text, read_integer<std::uint32_t>);
}

Parsed<std::uint64_t> parse_uint64(std::string_view text) {
  return read_one<std::uint64_t>(text, read_integer<std::uint64_t>);
}

Parsed<double> parse_double(std::string_view text) {
  return read_one<double>(text, read_real<double>);
}

Parsed<float> parse_float(std::string_view text) { return read_one<float>(text, read_real<float>); }

Parsed<std::array<double, 2>> parse_vector2(std::string_view text) {
  return read_array<double, 2>(text, read_finite);
}

Parsed<std::array<std::int32_t, 2>> parse_vector2i(std::string_view text) {
  return read_array<std::int32_t, 2>(text, read_integer<std::int32_t>);
}

Parsed<std::array<double, 3>> parse_vector3(std::string_view text) {
  return read_array<double, 3>(text, read_finite);
}

Parsed<std::array<double, 4>> parse_color(std::string_view text) {
  std::array<double, 4> values{0, 0, 0, 1};
  const auto read = [](std::string_view all, Token token) -> Parsed<double> {
    const Parsed<double> parsed = read_finite(all, token);
    const double* const value = std::get_if<double>(&parsed);
    if (value && (*value < 0 || *value > 1)) return fault(FaultKind::kBadColor, token);
    return parsed;
  };
  const Parsed<std::size_t> count = read_list(text, 3, std::span<double>(values), read);
  if (const ValueFault* found = std::get_if<ValueFault>(&count)) return *found;
  return values;
}

Parsed<SecondsAndNanoseconds> parse_time(std::string_view text) {
  constexpr std::int32_t kNanosecondsInSecond = 1'000'000'000;
  std::array<std::int32_t, 2> values{};
  bool nanoseconds = false;
  const auto read = [&nanoseconds](std::string_view all, Token token) -> Parsed<std::int32_t> {
    const Parsed<std::int32_t> parsed = read_integer<std::int32_t>(all, token);
    const std::int32_t* const value = std::get_if<std::int32_t>(&parsed);
    const bool outside = value && nanoseconds && (*value < 0 || *value >= kNanosecondsInSecond);
    // "1.5" is a number, only not a whole one
    const bool fraction = !value && std::holds_alternative<double>(read_real<double>(all, token));
    nanoseconds = true;
    if (outside || fraction) return fault(FaultKind::kBadTime, token);
    return parsed;
  };
  const Parsed<std::size_t> count = read_list(text, 2, std::span<std::int32_t>(values), read);
  if (const ValueFault* found = std::get_if<ValueFault>(&count)) return *found;
  return SecondsAndNanoseconds{values[0], values[1]};
}

Parsed<PoseNumbers> parse_pose(std::string_view text, RotationFormat format) {
  const std::size_t wanted = format == RotationFormat::kQuatXyzw ? 7 : 6;
  PoseNumbers pose;
  const Parsed<std::size_t> count =
      read_list(text, wanted, std::span<double>(pose.numbers).first(wanted), read_finite);
  if (const ValueFault* found = std::get_if<ValueFault>(&count)) return *found;
  pose.count = static_cast<int>(wanted);
  return pose;
}

std::optional<ValueFault> check(Type type, std::string_view text, RotationFormat format) {
  const std::size_t reals = reals_of(type, format);
  if (reals > 0 && count_short_decimals(text) == reals) return std::nullopt;
  switch (type) {
    case Type::kNone:
    case Type::kString: return std::nullopt;
    case Type::kChar: {
      const Token whole = trim(text);
      if (whole.begin < whole.end) return std::nullopt;
      return ValueFault{FaultKind::kEmpty, 0, text.size()};
    }
    case Type::kBool: return fault_of(parse_bool(text));
    case Type::kInt: return fault_of(parse_int(text));
    case Type::kUint: return fault_of(parse_uint(text));
    case Type::kUint64: return fault_of(parse_uint64(text));
    case Type::kDouble: return fault_of(parse_double(text));
    case Type::kFloat: return fault_of(parse_float(text));
    case Type::kAngle: return fault_of(read_one<double>(text, read_finite));
    case Type::kVector2: return fault_of(parse_vector2(text));
    case Type::kVector2i: return fault_of(parse_vector2i(text));
    case Type::kVector3:
    case Type::kQuaternion:  // SDFormat writes this type as roll, pitch, yaw
      return fault_of(parse_vector3(text));
    case Type::kPose: return fault_of(parse_pose(text, format));
    case Type::kColor: return fault_of(parse_color(text));
    case Type::kTime: return fault_of(parse_time(text));
  }
  return std::nullopt;
}

NumberForm classify(std::string_view text) {
  const Parsed<double> parsed = parse_double(text);
  const double* const value = std::get_if<double>(&parsed);
  if (!value) return {};
  const Token token = trim(text);
  NumberForm form;
  form.infinite = std::isinf(*value);
  form.nan = std::isnan(*value);
  form.hexadecimal = take_prefix(text, token).hexadecimal;
  form.leading_plus = text[token.begin] == '+';
  form.subnormal = std::fpclassify(*value) == FP_SUBNORMAL;
  return form;
}

std::string to_shortest(double value) {
  // 24 characters hold any double: sign, 17 digits, point, e, sign, 3 digits
  std::array<char, 32> buffer;
  const std::to_chars_result written =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), written.ptr);
}

}  // namespace rigor::schema
