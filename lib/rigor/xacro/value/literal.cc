// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/literal.h>

#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/heap.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/number_text.h>

namespace rigor::xacro {

Value literal_value(Heap& heap, Value value) {
  if (!value.is_text()) return value;
  const std::string_view text = value.as_text();
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') {
    return Value::text(text.substr(1, text.size() - 2));
  }
  if (text.empty() || text.find('_') != std::string_view::npos) return value;
  // Most texts are names or expressions, which begin as no number does.
  constexpr std::string_view kNumberStarts = "+-.0123456789iInN \t\n\r\f\v";
  const bool may_be_number = kNumberStarts.find(text[0]) != std::string_view::npos ||
                             static_cast<signed char>(text[0]) < 0;
  if (may_be_number) {
    if (const Value number = plain_decimal(text); !number.failed()) return number;
    if (const Value whole = integer_from_text(heap, text); !whole.failed()) return whole;
    if (const auto real = real_from_text(text)) return Value::real(*real);
  }
  if (text == "true" || text == "True") return Value::boolean(true);
  if (text == "false" || text == "False") return Value::boolean(false);
  return value;
}

std::optional<bool> boolean_value(Heap& heap, Value value) {
  if (!value.is_text()) return is_true(value);
  const std::string_view text = value.as_text();
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  if (text == "0" || text == "1") return text == "1";
  const Value whole = integer_from_text(heap, text);
  if (whole.failed()) return std::nullopt;
  return !is_zero_integer(whole);
}

}  // namespace rigor::xacro
