// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The module `math` of the expression language: Python's, as of 3.11.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>

namespace rigor::xacro {
namespace {

using std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<double> real_argument(Evaluator& e, Value v) {
  if (v.is(Type::kReal)) return v.real_;
  if (!v.is_number()) {
    e.wrong_type("a number is due, not " + std::string(type_name(v)));
    return std::nullopt;
  }
  const double d = integer_to_double(v);
  if (std::isinf(d)) {
    e.wrong_value("the number is too large for a real number");
    return std::nullopt;
  }
  return d;
}

/// What C's function gives, by Python's rules: no NaN and no infinity that was not put in.
Value checked(Evaluator& e, double result, bool from_finite, bool from_nan) {
  if (std::isnan(result) && !from_nan) return e.wrong_value("math domain error");
  if (std::isinf(result) && from_finite) return e.wrong_value("math range error");
  return Value::real(result);
}

template <double (*F)(double)>
Value unary(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  return checked(e, F(*x), std::isfinite(*x), std::isnan(*x));
}

template <double (*F)(double, double)>
Value binary_math(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  if (!y) return Value::error();
  return checked(e, F(*x, *y), std::isfinite(*x) && std::isfinite(*y),
                 std::isnan(*x) || std::isnan(*y));
}

double to_radians(double x) { return x * (pi / 180.0); }
double to_degrees(double x) { return x * (180.0 / pi); }
double c_copysign(double x, double y) { return std::copysign(x, y); }
double c_exp2(double x) { return std::exp2(x); }
double c_cbrt(double x) { return std::cbrt(x); }
double c_erf(double x) { return std::erf(x); }
double c_erfc(double x) { return std::erfc(x); }
double c_sqrt(double x) { return std::sqrt(x); }
double c_fabs(double x) { return std::fabs(x); }
double c_atan2(double y, double x) { return std::atan2(y, x); }
/// In 80 bits, so that rounding the result is all that is lost.
double c_gamma(double x) {
  return x == std::floor(x) && x <= 0
             ? std::numeric_limits<double>::quiet_NaN()
             : static_cast<double>(std::tgamma(static_cast<long double>(x)));
}

using Unary = double (*)(double);
constexpr Unary c_sin = [](double x) { return std::sin(x); };
constexpr Unary c_cos = [](double x) { return std::cos(x); };
constexpr Unary c_tan = [](double x) { return std::tan(x); };
constexpr Unary c_asin = [](double x) { return std::asin(x); };
constexpr Unary c_acos = [](double x) { return std::acos(x); };
constexpr Unary c_atan = [](double x) { return std::atan(x); };
constexpr Unary c_sinh = [](double x) { return std::sinh(x); };
constexpr Unary c_cosh = [](double x) { return std::cosh(x); };
constexpr Unary c_tanh = [](double x) { return std::tanh(x); };
constexpr Unary c_asinh = [](double x) { return std::asinh(x); };
constexpr Unary c_acosh = [](double x) { return std::acosh(x); };
constexpr Unary c_exp = [](double x) { return std::exp(x); };
constexpr Unary c_expm1 = [](double x) { return std::expm1(x); };

Value math_lgamma(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  if (*x <= 0 && *x == std::floor(*x) && std::isfinite(*x))
    return e.wrong_value("math domain error");
  int sign = 0;
  return Value::real(static_cast<double>(lgammal_r(static_cast<long double>(*x), &sign)));
}

Value math_atanh(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  if (std::fabs(*x) >= 1) return e.wrong_value("math domain error");
  return Value::real(std::atanh(*x));
}

Value math_log1p(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  if (*x <= -1) return e.wrong_value("math domain error");
  return Value::real(std::log1p(*x));
}

/// The logarithm of what may be too large for a double: of its top bits, and the rest by count.
template <double (*F)(double)>
Value logarithm(Evaluator& e, Value v) {
  if (v.is(Type::kBigInteger) && !is_negative_integer(v)) {
    const double d = integer_to_double(v);
    if (std::isfinite(d)) return Value::real(F(d));
    const auto shift = static_cast<std::int64_t>(integer_bits(v)) - 64;
    const Value top =
        integer_operation(e.heap(), IntegerOperation::kShiftRight, v, Value::integer(shift));
    return Value::real(F(integer_to_double(top)) + static_cast<double>(shift) * F(2.0));
  }
  const auto x = real_argument(e, v);
  if (!x) return Value::error();
  if (*x <= 0) return e.wrong_value("math domain error");
  return Value::real(F(*x));
}
double c_log(double x) { return std::log(x); }
double c_log2(double x) { return std::log2(x); }
double c_log10(double x) { return std::log10(x); }

Value math_log(Evaluator& e, Value, Arguments& a) {
  const Value top = logarithm<c_log>(e, a.values[0]);
  if (top.failed() || !a.has(1)) return top;
  const Value bottom = logarithm<c_log>(e, a.values[1]);
  return bottom.failed() ? bottom : e.binary(Operation::kDivide, top, bottom);
}
Value math_log2(Evaluator& e, Value, Arguments& a) { return logarithm<c_log2>(e, a.values[0]); }
Value math_log10(Evaluator& e, Value, Arguments& a) { return logarithm<c_log10>(e, a.values[0]); }

Value math_pow(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  if (!y) return Value::error();
  if (*x == 0 && *y < 0 && std::isfinite(*y)) return e.wrong_value("math domain error");
  return checked(e, std::pow(*x, *y), std::isfinite(*x) && std::isfinite(*y),
                 std::isnan(*x) || std::isnan(*y));
}

Value math_fmod(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  if (!y) return Value::error();
  return checked(e, std::fmod(*x, *y), true, std::isnan(*x) || std::isnan(*y));
}

Value math_remainder(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  if (!y) return Value::error();
  return checked(e, std::remainder(*x, *y), true, std::isnan(*x) || std::isnan(*y));
}

enum class Rounding : std::uint8_t { kDown, kUp, kToZero };

template <Rounding R>
Value to_whole(Evaluator& e, Value, Arguments& a) {
  const Value v = a.values[0];
  if (v.is_integral()) return v.is(Type::kBool) ? Value::integer(v.integer_) : v;
  const auto x = real_argument(e, v);
  if (!x) return Value::error();
  if (!std::isfinite(*x))
    return e.wrong_value("no whole number is near " +
                         std::string(std::isnan(*x) ? "nan" : "infinity"));
  const double whole = R == Rounding::kDown ? std::floor(*x)
                       : R == Rounding::kUp ? std::ceil(*x)
                                            : std::trunc(*x);
  return e.number(integer_from_double(e.heap(), whole));
}

template <bool (*F)(double)>
Value predicate(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  return x ? Value::boolean(F(*x)) : Value::error();
}
bool c_isnan(double x) { return std::isnan(x); }
bool c_isinf(double x) { return std::isinf(x); }
bool c_isfinite(double x) { return std::isfinite(x); }

/// The length of a vector: summed in 80 bits.
Value length_of(Evaluator& e, const std::vector<Value>& parts) {
  long double sum = 0;
  bool nan = false;
  bool infinite = false;
  for (const Value part : parts) {
    const auto x = real_argument(e, part);
    if (!x) return Value::error();
    nan = nan || std::isnan(*x);
    infinite = infinite || std::isinf(*x);
    sum += static_cast<long double>(*x) * static_cast<long double>(*x);
  }
  if (infinite) return Value::real(kInfinity);
  if (nan) return Value::real(std::numeric_limits<double>::quiet_NaN());
  return Value::real(static_cast<double>(std::sqrt(sum)));
}

Value math_hypot(Evaluator& e, Value, Arguments& a) { return length_of(e, a.values); }

Value math_dist(Evaluator& e, Value, Arguments& a) {
  const auto p = e.items_of(a.values[0]);
  const auto q = p ? e.items_of(a.values[1]) : std::nullopt;
  if (!q) return Value::error();
  if (p->size() != q->size())
    return e.wrong_value("both points must have the same number of dimensions");
  std::vector<Value> parts;
  for (std::size_t i = 0; i < p->size(); ++i) {
    parts.push_back(e.binary(Operation::kSubtract, (*p)[i], (*q)[i]));
    if (parts.back().failed()) return parts.back();
  }
  return length_of(e, parts);
}

/// Shewchuk's exact sum: partial sums that do not overlap.
Value math_fsum(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  std::vector<double> partials;
  for (const Value item : *items) {
    const auto given = real_argument(e, item);
    if (!given) return Value::error();
    double x = *given;
    std::size_t kept = 0;
    for (double y : partials) {
      if (std::fabs(x) < std::fabs(y)) std::swap(x, y);
      const double high = x + y;
      const double low = y - (high - x);
      if (low != 0) partials[kept++] = low;
      x = high;
    }
    partials.resize(kept);
    partials.push_back(x);
  }
  double high = 0;
  double low = 0;
  while (!partials.empty() && low == 0) {
    const double x = high;
    const double y = partials.back();
    partials.pop_back();
    high = x + y;
    low = y - (high - x);
  }
  // What is left decides a tie.
  if (!partials.empty() && low != 0 && (low < 0) == (partials.back() < 0)) {
    const double twice = low * 2;
    if (twice == (high + twice) - high) high += twice;
  }
  return Value::real(high);
}

Value math_prod(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  Value product = a.find("start").value_or(Value::integer(1));
  for (const Value item : *items) {
    product = e.binary(Operation::kMultiply, product, item);
    if (product.failed()) break;
  }
  return product;
}

bool whole_arguments(Evaluator& e, const Arguments& a) {
  for (const Value v : a.values) {
    if (v.is_integral()) continue;
    e.wrong_type("a whole number is due, not " + std::string(type_name(v)));
    return false;
  }
  return true;
}

Value absolute(Evaluator& e, Value v) {
  return is_negative_integer(v) ? e.number(negated_integer(e.heap(), v)) : v;
}

Value greatest_common_divisor(Evaluator& e, Value a, Value b) {
  a = absolute(e, a);
  b = absolute(e, b);
  while (!a.failed() && !b.failed() && !is_zero_integer(b)) {
    const Value rest = e.binary(Operation::kModulo, a, b);
    a = b;
    b = rest;
  }
  return a.is(Type::kBool) ? Value::integer(a.integer_) : a;
}

Value math_gcd(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  Value result = Value::integer(0);
  for (const Value v : a.values)
    result = result.failed() ? result : greatest_common_divisor(e, result, v);
  return result;
}

Value math_lcm(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  Value result = Value::integer(1);
  for (const Value v : a.values) {
    if (is_zero_integer(v)) return Value::integer(0);
    const Value divisor = greatest_common_divisor(e, result, v);
    if (divisor.failed()) return divisor;
    result = e.binary(Operation::kMultiply, result,
                      e.binary(Operation::kFloorDivide, absolute(e, v), divisor));
    if (result.failed()) return result;
  }
  return result;
}

/// n * (n-1) * … of k factors.
Value falling_product(Evaluator& e, Value n, std::int64_t k) {
  Value product = Value::integer(1);
  for (std::int64_t i = 0; i < k && !product.failed(); ++i) {
    product = e.binary(Operation::kMultiply, product,
                       e.binary(Operation::kSubtract, n, Value::integer(i)));
  }
  return product;
}

/// More factors than this have more digits than the bound on numbers.
constexpr std::int64_t kMaxFactors = 10'000;

Value math_factorial(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  const Value n = a.values[0];
  if (is_negative_integer(n)) return e.wrong_value("the factorial of a negative number");
  if (!n.is_small() || n.integer_ > kMaxFactors) return e.number(Value::error());
  return falling_product(e, n, n.integer_);
}

Value math_perm(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  const Value n = a.values[0];
  const Value k = a.get(1, n);
  if (is_negative_integer(n) || is_negative_integer(k)) return e.wrong_value("a negative number");
  if (compare_integers(k, n) > 0) return Value::integer(0);
  if (!k.is_small() || k.integer_ > kMaxFactors) return e.number(Value::error());
  return falling_product(e, n, k.integer_);
}

Value math_comb(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  const Value n = a.values[0];
  Value k = a.values[1];
  if (is_negative_integer(n) || is_negative_integer(k)) return e.wrong_value("a negative number");
  if (compare_integers(k, n) > 0) return Value::integer(0);
  const Value other = e.binary(Operation::kSubtract, n, k);
  if (compare_integers(other, k) < 0) k = other;
  if (!k.is_small() || k.integer_ > kMaxFactors) return e.number(Value::error());
  Value result = Value::integer(1);
  for (std::int64_t i = 0; i < k.integer_ && !result.failed(); ++i) {
    result = e.binary(Operation::kMultiply, result,
                      e.binary(Operation::kSubtract, n, Value::integer(i)));
    if (!result.failed()) result = e.binary(Operation::kFloorDivide, result, Value::integer(i + 1));
  }
  return result;
}

Value math_isqrt(Evaluator& e, Value, Arguments& a) {
  if (!whole_arguments(e, a)) return Value::error();
  if (is_negative_integer(a.values[0])) return e.wrong_value("the root of a negative number");
  return e.number(integer_square_root(e.heap(), a.values[0]));
}

Value math_isclose(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  const auto relative =
      y ? real_argument(e, a.find("rel_tol").value_or(Value::real(1e-9))) : std::nullopt;
  const auto least =
      relative ? real_argument(e, a.find("abs_tol").value_or(Value::real(0))) : std::nullopt;
  if (!least) return Value::error();
  if (*relative < 0 || *least < 0) return e.wrong_value("a negative tolerance");
  if (*x == *y) return Value::boolean(true);
  if (std::isinf(*x) || std::isinf(*y)) return Value::boolean(false);
  const double difference = std::fabs(*x - *y);
  return Value::boolean(difference <= std::fabs(*relative * *y) ||
                        difference <= std::fabs(*relative * *x) || difference <= *least);
}

Value math_frexp(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  int exponent = 0;
  const double mantissa = std::frexp(*x, &exponent);
  return e.heap().tuple({Value::real(mantissa), Value::integer(std::isfinite(*x) ? exponent : 0)});
}

Value math_modf(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  double whole = 0;
  const double part = std::modf(*x, &whole);
  return e.heap().tuple({Value::real(part), Value::real(whole)});
}

Value math_ldexp(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  if (!x) return Value::error();
  if (!a.values[1].is_small()) return e.wrong_type("a whole number is due as exponent");
  const auto exponent =
      static_cast<int>(std::clamp<std::int64_t>(a.values[1].integer_, -5000, 5000));
  return checked(e, std::ldexp(*x, exponent), std::isfinite(*x), std::isnan(*x));
}

double c_nextafter(double x, double y) { return std::nextafter(x, y); }
Value math_nextafter(Evaluator& e, Value, Arguments& a) {
  const auto x = real_argument(e, a.values[0]);
  const auto y = x ? real_argument(e, a.values[1]) : std::nullopt;
  return y ? Value::real(c_nextafter(*x, *y)) : Value::error();
}

Value math_ulp(Evaluator& e, Value, Arguments& a) {
  const auto given = real_argument(e, a.values[0]);
  if (!given) return Value::error();
  const double x = std::fabs(*given);
  if (!std::isfinite(x)) return Value::real(x);
  const double above = std::nextafter(x, kInfinity);
  return Value::real(std::isinf(above) ? x - std::nextafter(x, 0) : above - x);
}

constexpr Function kMathFunctions[] = {{"acos", unary<c_acos>, 1, 1},
                                       {"acosh", unary<c_acosh>, 1, 1},
                                       {"asin", unary<c_asin>, 1, 1},
                                       {"asinh", unary<c_asinh>, 1, 1},
                                       {"atan", unary<c_atan>, 1, 1},
                                       {"atan2", binary_math<c_atan2>, 2, 2},
                                       {"atanh", math_atanh, 1, 1},
                                       {"cbrt", unary<c_cbrt>, 1, 1},
                                       {"ceil", to_whole<Rounding::kUp>, 1, 1},
                                       {"comb", math_comb, 2, 2},
                                       {"copysign", binary_math<c_copysign>, 2, 2},
                                       {"cos", unary<c_cos>, 1, 1},
                                       {"cosh", unary<c_cosh>, 1, 1},
                                       {"degrees", unary<to_degrees>, 1, 1},
                                       {"dist", math_dist, 2, 2},
                                       {"erf", unary<c_erf>, 1, 1},
                                       {"erfc", unary<c_erfc>, 1, 1},
                                       {"exp", unary<c_exp>, 1, 1},
                                       {"exp2", unary<c_exp2>, 1, 1},
                                       {"expm1", unary<c_expm1>, 1, 1},
                                       {"fabs", unary<c_fabs>, 1, 1},
                                       {"factorial", math_factorial, 1, 1},
                                       {"floor", to_whole<Rounding::kDown>, 1, 1},
                                       {"fmod", math_fmod, 2, 2},
                                       {"frexp", math_frexp, 1, 1},
                                       {"fsum", math_fsum, 1, 1},
                                       {"gamma", unary<c_gamma>, 1, 1},
                                       {"gcd", math_gcd, 0, kAnyCount},
                                       {"hypot", math_hypot, 0, kAnyCount},
                                       {"isclose", math_isclose, 2, 2, "rel_tol abs_tol"},
                                       {"isfinite", predicate<c_isfinite>, 1, 1},
                                       {"isinf", predicate<c_isinf>, 1, 1},
                                       {"isnan", predicate<c_isnan>, 1, 1},
                                       {"isqrt", math_isqrt, 1, 1},
                                       {"lcm", math_lcm, 0, kAnyCount},
                                       {"ldexp", math_ldexp, 2, 2},
                                       {"lgamma", math_lgamma, 1, 1},
                                       {"log", math_log, 1, 2},
                                       {"log10", math_log10, 1, 1},
                                       {"log1p", math_log1p, 1, 1},
                                       {"log2", math_log2, 1, 1},
                                       {"modf", math_modf, 1, 1},
                                       {"nextafter", math_nextafter, 2, 2},
                                       {"perm", math_perm, 1, 2},
                                       {"pow", math_pow, 2, 2},
                                       {"prod", math_prod, 1, 1, "start"},
                                       {"radians", unary<to_radians>, 1, 1},
                                       {"remainder", math_remainder, 2, 2},
                                       {"sin", unary<c_sin>, 1, 1},
                                       {"sinh", unary<c_sinh>, 1, 1},
                                       {"sqrt", unary<c_sqrt>, 1, 1},
                                       {"tan", unary<c_tan>, 1, 1},
                                       {"tanh", unary<c_tanh>, 1, 1},
                                       {"trunc", to_whole<Rounding::kToZero>, 1, 1},
                                       {"ulp", math_ulp, 1, 1}};

constexpr Constant kMathConstants[] = {{"e", std::numbers::e},
                                       {"inf", kInfinity},
                                       {"nan", std::numeric_limits<double>::quiet_NaN()},
                                       {"pi", pi},
                                       {"tau", 2 * pi}};

}  // namespace

const Module kMathModule{"math", {}, kMathFunctions, kMathConstants};

}  // namespace rigor::xacro
