// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the text of an attribute or element as a value of its type. The whole text must be the
// value: where C++'s stod and streams stop at the first character they do not understand ("1,5" is
// 1, "1.5kg" is 1.5), these functions say what is wrong and where. White space of XML around a
// value and between numbers is skipped. Nothing depends on the locale, and nothing is allocated.
//
//   Parsed<double> parsed = parse_double(" 1.5kg ");
//   if (const ValueFault* fault = std::get_if<ValueFault>(&parsed)) {
//     // fault->kind == ValueFault::Kind::kTrailingText, fault->begin == 4, fault->end == 6: "kg"
//   }
//   std::optional<ValueFault> fault = check(Type::kVector3, "1 2");  // TooFew
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <rigor/schema/type.h>

namespace rigor::schema {

struct ValueFault {
  enum class Kind : std::uint8_t {
    kEmpty,         // no text but white space
    kNotANumber,    // "wide"
    kTrailingText,  // "1.5kg", "1.5" for an integer; the span is what is too much
    kDecimalComma,  // "1,5", and so "1,2,3"; the span is the number with its comma
    kTooFew,        // "1 2" for a vector3; the span is the whole text
    kTooMany,       // "1 1 1 99" for a vector3; the span is what is too much
    kNotFinite,     // "inf" or "nan" in a vector, pose, color or angle
    kOutOfRange,    // too large for the type: "1e400", "3000000000" for an int
    kUnderflow,     // not zero, but nearer to it than any double: "1e-400"
    kNegative,      // "-1" for an unsigned number
    kBadBool,       // none of true, false, 1, 0
    kBadColor,      // a component below 0 or above 1: "255 0 0"
    kBadTime,       // not whole seconds and 0 to 999999999 whole nanoseconds
  };
  Kind kind;
  std::size_t begin, end;  // half-open, bytes of the given text

  bool operator==(const ValueFault&) const = default;
};

template <class T>
using Parsed = std::variant<T, ValueFault>;

// true, false, 1, 0; letters of any case.
Parsed<bool> parse_bool(std::string_view text);

// Decimal, or hexadecimal after 0x; a sign may lead.
Parsed<std::int32_t> parse_int(std::string_view text);
Parsed<std::uint32_t> parse_uint(std::string_view text);
Parsed<std::uint64_t> parse_uint64(std::string_view text);

// As strtod reads it: also inf, infinity, nan in any case, hexadecimal, and a leading +. The
// nearest double, which may be subnormal. classify() tells the unusual forms apart.
Parsed<double> parse_double(std::string_view text);
// The same, and within the range of a float unless infinite.
Parsed<float> parse_float(std::string_view text);

// A number of finite numbers, with white space between them.
Parsed<std::array<double, 2>> parse_vector2(std::string_view text);
Parsed<std::array<std::int32_t, 2>> parse_vector2i(std::string_view text);
Parsed<std::array<double, 3>> parse_vector3(std::string_view text);

// Red, green, blue and alpha, each from 0 to 1; alpha is 1 when only three are written.
Parsed<std::array<double, 4>> parse_color(std::string_view text);

struct SecondsAndNanoseconds {
  std::int32_t seconds = 0;
  std::int32_t nanoseconds = 0;  // 0 to 999999999
  bool operator==(const SecondsAndNanoseconds&) const = default;
};
Parsed<SecondsAndNanoseconds> parse_time(std::string_view text);

enum class RotationFormat : std::uint8_t {
  kEulerRpy,  // six numbers: x y z roll pitch yaw
  kQuatXyzw,  // seven: x y z, then the quaternion's x y z w
};

// The numbers as they are written: no unit is converted and no quaternion normalized.
struct PoseNumbers {
  std::array<double, 7> numbers{};
  int count = 0;  // 6 or 7
  bool operator==(const PoseNumbers&) const = default;
};
Parsed<PoseNumbers> parse_pose(std::string_view text,
                               RotationFormat format = RotationFormat::kEulerRpy);

// Whether the text is a value of the type; nothing when it is. None, String and Char take any text,
// but Char not the empty one. A pose is six numbers unless the format says otherwise.
std::optional<ValueFault> check(Type type, std::string_view text,
                                RotationFormat format = RotationFormat::kEulerRpy);

// What is unusual about a number that parse_double() reads; a rule decides what to think of it.
struct NumberForm {
  bool infinite = false;
  bool nan = false;
  bool hexadecimal = false;
  bool leading_plus = false;
  bool subnormal = false;  // readers built on stod refuse it, by errno
  bool operator==(const NumberForm&) const = default;
};
// Of one number, white space around it skipped; all false for text that is no number.
NumberForm classify(std::string_view text);

// The shortest text that parse_double() reads back as the same number: "0.1", "1e+16", "-inf".
std::string to_shortest(double value);

}  // namespace rigor::schema
