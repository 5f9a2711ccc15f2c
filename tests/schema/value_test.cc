// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/value.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <variant>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

using Kind = ValueFault::Kind;

template <class T>
T value_of(const Parsed<T>& parsed) {
  const T* const value = std::get_if<T>(&parsed);
  EXPECT_NE(value, nullptr);
  return value ? *value : T{};
}

template <class T>
void expect_fault(const Parsed<T>& parsed, Kind kind, std::size_t begin, std::size_t end) {
  const ValueFault* const fault = std::get_if<ValueFault>(&parsed);
  ASSERT_NE(fault, nullptr) << "no fault";
  EXPECT_EQ(static_cast<int>(fault->kind), static_cast<int>(kind));
  EXPECT_EQ(fault->begin, begin);
  EXPECT_EQ(fault->end, end);
}

TEST(Value, DoubleReadsWholeNumbersOnly) {
  EXPECT_EQ(value_of(parse_double("1.5")), 1.5);
  EXPECT_EQ(value_of(parse_double(" \t\r\n-2e3\n")), -2000.0);
  EXPECT_EQ(value_of(parse_double("+.5")), 0.5);
  EXPECT_EQ(value_of(parse_double("5.")), 5.0);
  EXPECT_EQ(value_of(parse_double("0x10")), 16.0);
  EXPECT_EQ(value_of(parse_double("-0X1.8p1")), -3.0);
  EXPECT_EQ(value_of(parse_double("1e-320")), 1e-320);
  EXPECT_TRUE(std::signbit(value_of(parse_double("-0"))));
  EXPECT_EQ(value_of(parse_double("inf")), std::numeric_limits<double>::infinity());
  EXPECT_EQ(value_of(parse_double("-Infinity")), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(value_of(parse_double("NaN"))));
}

TEST(Value, DoubleSaysWhatIsWrongAndWhere) {
  expect_fault(parse_double(""), Kind::kEmpty, 0, 0);
  expect_fault(parse_double("  "), Kind::kEmpty, 0, 2);
  expect_fault(parse_double(" wide "), Kind::kNotANumber, 1, 5);
  expect_fault(parse_double("+-1"), Kind::kNotANumber, 0, 3);
  expect_fault(parse_double("--1"), Kind::kNotANumber, 0, 3);
  expect_fault(parse_double("-"), Kind::kNotANumber, 0, 1);
  expect_fault(parse_double("."), Kind::kNotANumber, 0, 1);
  expect_fault(parse_double(" 1.5kg "), Kind::kTrailingText, 4, 6);
  expect_fault(parse_double("1.5 kg"), Kind::kTrailingText, 4, 6);
  expect_fault(parse_double("1.2.3"), Kind::kTrailingText, 3, 5);
  expect_fault(parse_double("0x"), Kind::kTrailingText, 1, 2);
  expect_fault(parse_double("1,5"), Kind::kDecimalComma, 0, 3);
  expect_fault(parse_double("1,"), Kind::kTrailingText, 1, 2);
  expect_fault(parse_double("1 2 3"), Kind::kTooMany, 2, 5);
  expect_fault(parse_double("\xC2\xA0"
                            "1"),
               Kind::kNotANumber, 0, 3);
}

TEST(Value, DoubleTellsTooLargeFromTooSmall) {
  expect_fault(parse_double("1e400"), Kind::kOutOfRange, 0, 5);
  expect_fault(parse_double("-1e400"), Kind::kOutOfRange, 0, 6);
  expect_fault(parse_double("1e-400"), Kind::kUnderflow, 0, 6);
  expect_fault(parse_double("0.0000001e-400"), Kind::kUnderflow, 0, 14);
  expect_fault(parse_double("100e-9999999999999999999"), Kind::kUnderflow, 0, 24);
  expect_fault(parse_double("0.1e9999999999999999999"), Kind::kOutOfRange, 0, 23);
  expect_fault(parse_double(std::string(400, '9')), Kind::kOutOfRange, 0, 400);
  expect_fault(parse_double("0." + std::string(400, '0') + "1"), Kind::kUnderflow, 0, 403);
  expect_fault(parse_double("0x1p5000"), Kind::kOutOfRange, 0, 8);
  expect_fault(parse_double("0x1p-5000"), Kind::kUnderflow, 0, 9);
  EXPECT_EQ(value_of(parse_double("0e-999")), 0.0);
}

TEST(Value, EveryDoubleSurvivesItsShortestText) {
  std::mt19937_64 random(20260821);  // any seed: the property holds for all bit patterns
  for (int i = 0; i < 200'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    const std::string text = to_shortest(value);
    const double back = value_of(parse_double(text));
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Value, ShortDecimalsAreReadExactly) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    const std::size_t digits = 1 + random() % 17;
    std::string text;
    for (std::size_t k = 0; k < digits; ++k) text += static_cast<char>('0' + random() % 10);
    if (random() % 3 != 0) text.insert(random() % (digits + 1), ".");
    if (random() % 4 == 0) text.insert(0, random() % 2 == 0 ? "-" : "+");
    const auto parsed = parse_double(text);
    const double* value = std::get_if<double>(&parsed);
    ASSERT_NE(value, nullptr) << text;
    const double expected = std::strtod(text.c_str(), nullptr);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(expected)) << text;
  }
}

TEST(Value, ShortestTextIsShort) {
  EXPECT_EQ(to_shortest(0.1), "0.1");
  EXPECT_EQ(to_shortest(-2), "-2");
  EXPECT_EQ(to_shortest(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(to_shortest(1e16), "1e+16");
  EXPECT_EQ(to_shortest(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(to_shortest(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
  EXPECT_EQ(to_shortest(-std::numeric_limits<double>::denorm_min()), "-5e-324");
}

TEST(Value, FloatHasItsOwnRange) {
  EXPECT_EQ(value_of(parse_float("0.1")), 0.1f);
  EXPECT_EQ(value_of(parse_float("inf")), std::numeric_limits<float>::infinity());
  expect_fault(parse_float("1e39"), Kind::kOutOfRange, 0, 4);
  expect_fault(parse_float("1e-60"), Kind::kUnderflow, 0, 5);
}

TEST(Value, IntegersKeepTheirRange) {
  EXPECT_EQ(value_of(parse_int(" +7 ")), 7);
  EXPECT_EQ(value_of(parse_int("-2147483648")), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(value_of(parse_int("0x1F")), 31);
  expect_fault(parse_int("2147483648"), Kind::kOutOfRange, 0, 10);
  expect_fault(parse_int("-2147483649"), Kind::kOutOfRange, 0, 11);
  expect_fault(parse_int("99999999999999999999999"), Kind::kOutOfRange, 0, 23);
  expect_fault(parse_int("1.5"), Kind::kTrailingText, 1, 3);
  expect_fault(parse_int("1,5"), Kind::kDecimalComma, 0, 3);
  expect_fault(parse_int("1e3"), Kind::kTrailingText, 1, 3);
  expect_fault(parse_int("--1"), Kind::kNotANumber, 0, 3);
  EXPECT_EQ(value_of(parse_uint("4294967295")), 4294967295u);
  expect_fault(parse_uint("4294967296"), Kind::kOutOfRange, 0, 10);
  expect_fault(parse_uint(" -1"), Kind::kNegative, 1, 3);
  EXPECT_EQ(value_of(parse_uint64("18446744073709551615")),
            std::numeric_limits<std::uint64_t>::max());
  expect_fault(parse_uint64("18446744073709551616"), Kind::kOutOfRange, 0, 20);
}

TEST(Value, BoolHasFourWords) {
  EXPECT_TRUE(value_of(parse_bool(" TRUE\n")));
  EXPECT_TRUE(value_of(parse_bool("1")));
  EXPECT_FALSE(value_of(parse_bool("False")));
  EXPECT_FALSE(value_of(parse_bool("0")));
  expect_fault(parse_bool("yes"), Kind::kBadBool, 0, 3);
  expect_fault(parse_bool("1 0"), Kind::kBadBool, 0, 3);
  expect_fault(parse_bool(""), Kind::kEmpty, 0, 0);
}

TEST(Value, VectorsCountTheirNumbers) {
  EXPECT_EQ(value_of(parse_vector3(" 1\t2\n 3 ")), (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(value_of(parse_vector2("0.5 -1")), (std::array<double, 2>{0.5, -1}));
  EXPECT_EQ(value_of(parse_vector2i("3 -4")), (std::array<std::int32_t, 2>{3, -4}));
  expect_fault(parse_vector3(""), Kind::kEmpty, 0, 0);
  expect_fault(parse_vector3(" 1 2 "), Kind::kTooFew, 1, 4);
  expect_fault(parse_vector3("1 1 1 99 "), Kind::kTooMany, 6, 8);
  expect_fault(parse_vector3("1,2,3"), Kind::kDecimalComma, 0, 5);
  expect_fault(parse_vector3("1, 2, 3"), Kind::kTrailingText, 1, 2);
  expect_fault(parse_vector3("1 two 3"), Kind::kNotANumber, 2, 5);
  expect_fault(parse_vector3("1 inf 3"), Kind::kNotFinite, 2, 5);
  expect_fault(parse_vector2i("1 2.5"), Kind::kTrailingText, 3, 5);
}

TEST(Value, ColorIsThreeOrFourFromZeroToOne) {
  EXPECT_EQ(value_of(parse_color("0 .5 1")), (std::array<double, 4>{0, 0.5, 1, 1}));
  EXPECT_EQ(value_of(parse_color("0 0 0 0.25")), (std::array<double, 4>{0, 0, 0, 0.25}));
  expect_fault(parse_color("0 0"), Kind::kTooFew, 0, 3);
  expect_fault(parse_color("0 0 0 0 0"), Kind::kTooMany, 8, 9);
  expect_fault(parse_color("1 255 0"), Kind::kBadColor, 2, 5);
  expect_fault(parse_color("-0.1 0 0"), Kind::kBadColor, 0, 4);
  expect_fault(parse_color("nan 0 0"), Kind::kNotFinite, 0, 3);
}

TEST(Value, TimeIsTwoIntegers) {
  EXPECT_EQ(value_of(parse_time("12 999999999")), (SecondsAndNanoseconds{12, 999999999}));
  EXPECT_EQ(value_of(parse_time("-1 0")), (SecondsAndNanoseconds{-1, 0}));
  expect_fault(parse_time("1.5 0"), Kind::kBadTime, 0, 3);
  expect_fault(parse_time("1.5"), Kind::kBadTime, 0, 3);
  expect_fault(parse_time("1 1000000000"), Kind::kBadTime, 2, 12);
  expect_fault(parse_time("1 -1"), Kind::kBadTime, 2, 4);
  expect_fault(parse_time("5"), Kind::kTooFew, 0, 1);
  expect_fault(parse_time("5 soon"), Kind::kNotANumber, 2, 6);
}

TEST(Value, PoseHasSixNumbersOrSeven) {
  const PoseNumbers euler = value_of(parse_pose("1 2 3 0.1 0.2 0.3"));
  EXPECT_EQ(euler, (PoseNumbers{{1, 2, 3, 0.1, 0.2, 0.3, 0}, 6}));
  const PoseNumbers quaternion = value_of(parse_pose("1 2 3 0 0 0 1", RotationFormat::kQuatXyzw));
  EXPECT_EQ(quaternion, (PoseNumbers{{1, 2, 3, 0, 0, 0, 1}, 7}));
  expect_fault(parse_pose("1 2 3"), Kind::kTooFew, 0, 5);
  expect_fault(parse_pose("1 2 3 0 0 0 1"), Kind::kTooMany, 12, 13);
  expect_fault(parse_pose("1 2 3 0 0 0", RotationFormat::kQuatXyzw), Kind::kTooFew, 0, 11);
  expect_fault(parse_pose("0 0 nan 0 0 0"), Kind::kNotFinite, 4, 7);
}

TEST(Value, CheckFollowsTheType) {
  EXPECT_EQ(check(Type::kNone, "anything"), std::nullopt);
  EXPECT_EQ(check(Type::kString, ""), std::nullopt);
  EXPECT_EQ(check(Type::kChar, " x"), std::nullopt);
  EXPECT_EQ(check(Type::kChar, " "), (ValueFault{Kind::kEmpty, 0, 1}));
  EXPECT_EQ(check(Type::kBool, "true"), std::nullopt);
  EXPECT_EQ(check(Type::kBool, "2"), (ValueFault{Kind::kBadBool, 0, 1}));
  EXPECT_EQ(check(Type::kInt, "-3"), std::nullopt);
  EXPECT_EQ(check(Type::kUint, "-3"), (ValueFault{Kind::kNegative, 0, 2}));
  EXPECT_EQ(check(Type::kUint64, "5000000000"), std::nullopt);
  EXPECT_EQ(check(Type::kDouble, "inf"), std::nullopt);
  EXPECT_EQ(check(Type::kFloat, "1e39"), (ValueFault{Kind::kOutOfRange, 0, 4}));
  EXPECT_EQ(check(Type::kAngle, "inf"), (ValueFault{Kind::kNotFinite, 0, 3}));
  EXPECT_EQ(check(Type::kVector2, "1 2 3"), (ValueFault{Kind::kTooMany, 4, 5}));
  EXPECT_EQ(check(Type::kVector2i, "1 2"), std::nullopt);
  EXPECT_EQ(check(Type::kVector3, "1 2 3"), std::nullopt);
  EXPECT_EQ(check(Type::kQuaternion, "0 0 1.57"), std::nullopt);
  EXPECT_EQ(check(Type::kPose, "0 0 0 0 0 0"), std::nullopt);
  EXPECT_EQ(check(Type::kPose, "0 0 0 0 0 0 1", RotationFormat::kQuatXyzw), std::nullopt);
  EXPECT_EQ(check(Type::kColor, "1 1 1"), std::nullopt);
  EXPECT_EQ(check(Type::kTime, "0 0"), std::nullopt);
}

TEST(Value, ClassifyNamesUnusualForms) {
  EXPECT_EQ(classify("1.5"), NumberForm{});
  EXPECT_EQ(classify("wide"), NumberForm{});
  EXPECT_EQ(classify("-inf"), (NumberForm{.infinite = true}));
  EXPECT_EQ(classify(" NAN "), (NumberForm{.nan = true}));
  EXPECT_EQ(classify("0x10"), (NumberForm{.hexadecimal = true}));
  EXPECT_EQ(classify("+1"), (NumberForm{.leading_plus = true}));
  EXPECT_EQ(classify("1e-320"), (NumberForm{.subnormal = true}));
}

}  // namespace
}  // namespace rigor::schema
