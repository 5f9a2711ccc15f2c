// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <rigor/text/letter_case.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/number_text.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

/// A width or precision past it is no number's; it bounds what a few bytes can ask for.
constexpr int kMaxFormatWidth = 10'000;

struct FormatSpec {
  std::string fill = " ";
  char align = 0;  ///< one of `<>^=`
  char sign = '-';
  bool alternate = false;
  int width = 0;
  char grouping = 0;
  int precision = -1;
  char type = 0;
};

std::string grouped(std::string digits, char separator, std::size_t every) {
  const std::size_t end =
      std::min(digits.find_first_not_of("0123456789abcdefABCDEF"), digits.size());
  for (std::size_t at = end; at > every; at -= every) digits.insert(at - every, 1, separator);
  return digits;
}

std::string padded(std::string sign, std::string body, const FormatSpec& spec, char usual) {
  const std::size_t size = code_points(sign) + code_points(body);
  const auto width = static_cast<std::size_t>(spec.width);
  if (size >= width) return sign + body;
  const std::size_t missing = width - size;
  const char align = spec.align != 0 ? spec.align : usual;
  const auto fill = [&spec](std::size_t n) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) text += spec.fill;
    return text;
  };
  if (align == '=') return sign + fill(missing) + body;
  const std::size_t before = align == '<' ? 0 : align == '>' ? missing : missing / 2;
  return fill(before) + sign + body + fill(missing - before);
}

std::string sign_of(bool negative, const FormatSpec& spec) {
  return negative ? "-" : spec.sign == '-' ? "" : std::string(1, spec.sign);
}

std::string real_body(double magnitude, const FormatSpec& spec) {
  const char type = lower(spec.type);
  std::string body;
  if (type == 'f' || type == '%') {
    body = fixed_text(type == '%' ? magnitude * 100 : magnitude,
                      spec.precision < 0 ? 6 : spec.precision);
    if (type == '%') body += '%';
  } else if (type == 'e') {
    body = exponent_text(magnitude, spec.precision < 0 ? 6 : spec.precision);
  } else if (type == 'g' || type == 'n') {
    body = general_text(magnitude, spec.precision < 0 ? 6 : spec.precision,
                        spec.alternate ? TrailingZeros::kKept : TrailingZeros::kDropped);
  } else if (spec.precision < 0) {
    body = real_to_text(magnitude);
  } else {
    // Without a type: as `g`, with at least one digit behind the point.
    body = general_text(magnitude, spec.precision);
    if (std::isfinite(magnitude) && body.find_first_of(".e") == std::string::npos) body += ".0";
  }
  if (spec.type >= 'A' && spec.type <= 'Z') {
    for (char& c : body) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return spec.grouping != 0 ? grouped(std::move(body), spec.grouping, 3) : body;
}

std::optional<std::string> integer_body(Evaluator& evaluator, Value v, const FormatSpec& spec) {
  const char type = lower(spec.type);
  const int base = type == 'x' ? 16 : type == 'o' ? 8 : type == 'b' ? 2 : 10;
  std::optional<std::string> digits = integer_to_text(v, base);
  if (!digits) {
    evaluator.fail(FactKind::kBoundReached, {}, "the digits of a number");
    return std::nullopt;
  }
  if (digits->starts_with('-')) digits->erase(0, 1);
  if (spec.grouping != 0) *digits = grouped(std::move(*digits), spec.grouping, base == 10 ? 3 : 4);
  if (spec.alternate && base != 10) *digits = std::string("0") + type + *digits;
  if (spec.type == 'X') {
    for (char& c : *digits) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return digits;
}

std::optional<std::string> formatted(Evaluator& evaluator, Value v, const FormatSpec& spec) {
  constexpr std::string_view kReals = "eEfFgGn%";
  if (v.is(Type::kReal) ||
      (v.is_integral() && spec.type != 0 && kReals.find(spec.type) != std::string_view::npos)) {
    const double d = v.is(Type::kReal) ? v.real_ : integer_to_double(v);
    if (spec.type != 0 && kReals.find(spec.type) == std::string_view::npos) {
      evaluator.wrong_value(std::string("no format '") + spec.type + "' for a float");
      return std::nullopt;
    }
    return padded(sign_of(std::signbit(d) && !std::isnan(d), spec), real_body(std::fabs(d), spec),
                  spec, '>');
  }
  if (v.is_integral() && !(v.is(Type::kBool) && spec.type == 0)) {
    constexpr std::string_view kIntegers = "dboxX";
    if (spec.type != 0 && kIntegers.find(spec.type) == std::string_view::npos) {
      evaluator.wrong_value(std::string("no format '") + spec.type + "' for an int");
      return std::nullopt;
    }
    auto body = integer_body(evaluator, v, spec);
    if (!body) return std::nullopt;
    return padded(sign_of(is_negative_integer(v), spec), std::move(*body), spec, '>');
  }
  if (spec.type != 0 && spec.type != 's') {
    evaluator.wrong_value(std::string("no format '") + spec.type + "' for a " +
                          std::string(type_name(v)));
    return std::nullopt;
  }
  auto text = evaluator.text_of(v);
  if (!text) return std::nullopt;
  if (spec.precision >= 0)
    *text = code_point_range(*text, 0, static_cast<std::size_t>(spec.precision));
  return padded({}, std::move(*text), spec, '<');
}

int read_number(std::string_view text, std::size_t& at) {
  int number = 0;
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
    number = std::min(number * 10 + (text[at] - '0'), kMaxFormatWidth + 1);
  }
  return number;
}

/// `[[fill]align][sign][#][0][width][grouping][.precision][type]`; false when it is none.
bool parse_format_spec(std::string_view text, FormatSpec& spec) {
  constexpr std::string_view kAligns = "<>=^";
  std::size_t at = 0;
  const std::size_t second = byte_of(text, 1);
  if (second < text.size() && kAligns.find(text[second]) != std::string_view::npos) {
    spec.fill = text.substr(0, second);
    spec.align = text[second];
    at = second + 1;
  } else if (!text.empty() && kAligns.find(text[0]) != std::string_view::npos) {
    spec.align = text[at++];
  }
  const auto peek = [&] { return at < text.size() ? text[at] : '\0'; };
  if (peek() == '+' || peek() == '-' || peek() == ' ') spec.sign = text[at++];
  if (peek() == '#') {
    spec.alternate = true;
    ++at;
  }
  if (peek() == '0') {
    if (spec.align == 0) {
      spec.fill = "0";
      spec.align = '=';
    }
    ++at;
  }
  spec.width = read_number(text, at);
  if (peek() == ',' || peek() == '_') spec.grouping = text[at++];
  if (peek() == '.') {
    const std::size_t before = ++at;
    spec.precision = read_number(text, at);
    if (at == before) return false;
  }
  if (at < text.size()) spec.type = text[at++];
  return at == text.size() && spec.width <= kMaxFormatWidth && spec.precision <= kMaxFormatWidth;
}

}  // namespace

double rounded(double d, int digits) {
  // Past these Python has nothing to round, or nothing left.
  if (!std::isfinite(d) || digits > 323) return d;
  if (digits < -308) return std::copysign(0.0, d);
  if (digits >= 0)
    return std::copysign(plain_real(fixed_text(std::fabs(d), digits)).value_or(d), d);
  const double power = std::pow(10.0, -digits);
  return std::copysign(std::nearbyint(std::fabs(d) / power) * power, d);
}

std::optional<std::string> format_percent(Evaluator& evaluator, std::string_view format,
                                          Value values) {
  const auto refuse = [&evaluator](std::string why) {
    evaluator.wrong_type(std::move(why));
    return std::nullopt;
  };
  const bool several = values.is(Type::kTuple);
  const std::vector<Value> given =
      several ? values.sequence_->items->values : std::vector<Value>{values};
  std::size_t next = 0;
  bool by_name = false;
  std::string result;
  for (std::size_t at = 0; at < format.size();) {
    if (format[at] != '%') {
      result += format[at++];
      continue;
    }
    ++at;
    FormatSpec spec;
    std::optional<Value> value;
    if (at < format.size() && format[at] == '(') {
      const std::size_t close = format.find(')', at);
      if (close == std::string_view::npos || !values.is(Type::kDictionary))
        return refuse("a format that needs a dictionary");
      by_name = true;
      value = evaluator.subscript(
          values, Value::text(evaluator.heap().keep(format.substr(at + 1, close - at - 1))));
      if (value->failed()) return std::nullopt;
      at = close + 1;
    }
    bool left = false;
    bool zeros = false;
    for (;
         at < format.size() && std::string_view("-+ #0").find(format[at]) != std::string_view::npos;
         ++at) {
      if (format[at] == '-') left = true;
      if (format[at] == '0') zeros = true;
      if (format[at] == '#') spec.alternate = true;
      if (format[at] == '+' || (format[at] == ' ' && spec.sign != '+')) spec.sign = format[at];
    }
    const auto star_or_number = [&](int otherwise) {
      if (at >= format.size() || format[at] != '*')
        return at < format.size() ? read_number(format, at) : otherwise;
      ++at;
      const Value n = next < given.size() ? given[next++] : Value::none();
      return n.is_small()
                 ? static_cast<int>(std::clamp<std::int64_t>(n.integer_, 0, kMaxFormatWidth))
                 : otherwise;
    };
    spec.width = star_or_number(0);
    if (at < format.size() && format[at] == '.') {
      ++at;
      spec.precision = star_or_number(0);
    }
    if (at >= format.size()) return refuse("a format that ends within a %");
    if (spec.width > kMaxFormatWidth || spec.precision > kMaxFormatWidth) {
      evaluator.fail(FactKind::kBoundReached, {}, "the width of a format");
      return std::nullopt;
    }
    const char type = format[at++];
    if (type == '%') {
      result += '%';
      continue;
    }
    if (!value) {
      if (next >= given.size()) return refuse("fewer values than the format takes");
      value = given[next++];
    }
    spec.align = left ? '<' : zeros && type != 's' && type != 'r' ? '=' : '>';
    if (zeros && !left && type != 's' && type != 'r') spec.fill = "0";
    if (type == 's' || type == 'r') {
      auto text = type == 's' ? evaluator.text_of(*value) : evaluator.repr_of(*value);
      if (!text) return std::nullopt;
      if (spec.precision >= 0)
        *text = code_point_range(*text, 0, static_cast<std::size_t>(spec.precision));
      result += padded({}, std::move(*text), spec, '>');
    } else if (type == 'd' || type == 'i' || type == 'u' || type == 'x' || type == 'X' ||
               type == 'o') {
      if (!value->is_number() || (value->is(Type::kReal) && (!std::isfinite(value->real_) ||
                                                             lower(type) == 'x' || type == 'o'))) {
        return refuse(std::string("%") + type + " takes a whole number");
      }
      const Value whole = value->is(Type::kReal)
                              ? integer_from_double(evaluator.heap(), std::trunc(value->real_))
                              : *value;
      spec.type = type == 'i' || type == 'u' ? 'd' : type;
      auto body = integer_body(evaluator, whole, spec);
      if (!body) return std::nullopt;
      if (spec.precision > static_cast<int>(body->size()))
        body->insert(0, static_cast<std::size_t>(spec.precision) - body->size(), '0');
      result += padded(sign_of(is_negative_integer(whole), spec), std::move(*body), spec, '>');
    } else if (std::string_view("eEfFgG").find(type) != std::string_view::npos) {
      if (!value->is_number()) return refuse(std::string("%") + type + " takes a number");
      spec.type = type;
      const auto text = formatted(evaluator, *value, spec);
      if (!text) return std::nullopt;
      result += *text;
    } else if (type == 'c' && value->is_text() && code_points(value->as_text()) == 1) {
      result += padded({}, std::string(value->as_text()), spec, '>');
    } else {
      evaluator.wrong_value(std::string("no format %") + type);
      return std::nullopt;
    }
    if (result.size() > evaluator.bounds().text_bytes || !evaluator.work(1))
      return refuse("a text too long");
  }
  if (next < given.size() && !by_name &&
      !(values.is(Type::kDictionary) || values.is(Type::kList))) {
    return refuse("more values than the format takes");
  }
  return result;
}

std::optional<std::string> format_braces(Evaluator& evaluator, std::string_view format,
                                         const Arguments& arguments) {
  const auto refuse = [&evaluator](std::string why) {
    evaluator.wrong_value(std::move(why));
    return std::nullopt;
  };
  std::string result;
  std::size_t next = 0;
  for (std::size_t at = 0; at < format.size();) {
    const char c = format[at];
    if (c != '{' && c != '}') {
      result += c;
      ++at;
      continue;
    }
    if (at + 1 < format.size() && format[at + 1] == c) {
      result += c;
      at += 2;
      continue;
    }
    const std::size_t close = format.find('}', at);
    if (c == '}' || close == std::string_view::npos) return refuse("a single brace in a format");
    std::string_view field = format.substr(at + 1, close - at - 1);
    at = close + 1;
    if (field.find('{') != std::string_view::npos) {
      evaluator.fail(FactKind::kOutsideLanguage, {}, "fields within fields of a format");
      return std::nullopt;
    }
    FormatSpec spec;
    if (const std::size_t colon = field.find(':'); colon != std::string_view::npos) {
      if (!parse_format_spec(field.substr(colon + 1), spec))
        return refuse("a format's specification that is none");
      field = field.substr(0, colon);
    }
    char conversion = 0;
    if (field.size() >= 2 && field[field.size() - 2] == '!') {
      conversion = field.back();
      field.remove_suffix(2);
    }
    if (field.find_first_of(".[") != std::string_view::npos) {
      evaluator.fail(FactKind::kOutsideLanguage, {}, "attributes and items in a format's field");
      return std::nullopt;
    }
    std::optional<Value> value;
    if (field.empty() || (field[0] >= '0' && field[0] <= '9')) {
      std::size_t digits = 0;
      const std::size_t index =
          field.empty() ? next++ : static_cast<std::size_t>(read_number(field, digits));
      if (arguments.has(index)) value = arguments.get(index);
    } else {
      value = arguments.find(field);
    }
    if (!value) return refuse("no value for a format's field {" + std::string(field) + "}");
    if (conversion == 'r' || conversion == 's') {
      const auto text = conversion == 'r' ? evaluator.repr_of(*value) : evaluator.text_of(*value);
      if (!text) return std::nullopt;
      value = evaluator.text(*text);
    }
    const auto text = formatted(evaluator, *value, spec);
    if (!text) return std::nullopt;
    result += *text;
    if (result.size() > evaluator.bounds().text_bytes || !evaluator.work(1))
      return refuse("a text too long");
  }
  return result;
}

}  // namespace rigor::xacro
