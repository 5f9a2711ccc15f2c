// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Binary operators and comparisons of `Evaluator`, by the types of their operands.

#include <cmath>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/format.h>
#include <rigor/xacro/value/integer.h>

namespace rigor::xacro {
namespace {

double as_real(Value v) { return v.is(Type::kReal) ? v.real_ : integer_to_double(v); }

/// The remainder with the divisor's sign, as Python's float_rem has it.
double real_modulo(double a, double b) {
  double r = std::fmod(a, b);
  if (r != 0) return (b < 0) != (r < 0) ? r + b : r;
  return std::copysign(0.0, b);
}

/// Python's float_floor_div: the quotient of what the remainder leaves, rounded down.
double real_floor_quotient(double a, double b) {
  const double r = std::fmod(a, b);
  double quotient = (a - r) / b;
  if (r != 0 && (b < 0) != (r < 0)) quotient -= 1;
  if (quotient == 0) return std::copysign(0.0, a / b);
  const double down = std::floor(quotient);
  return quotient - down > 0.5 ? down + 1 : down;
}

std::optional<IntegerOperation> integer_operation_for(Operation operation) {
  switch (operation) {
    case Operation::kAdd: return IntegerOperation::kAdd;
    case Operation::kSubtract: return IntegerOperation::kSubtract;
    case Operation::kMultiply: return IntegerOperation::kMultiply;
    case Operation::kFloorDivide: return IntegerOperation::kFloorDivide;
    case Operation::kModulo: return IntegerOperation::kModulo;
    case Operation::kPower: return IntegerOperation::kPower;
    case Operation::kShiftLeft: return IntegerOperation::kShiftLeft;
    case Operation::kShiftRight: return IntegerOperation::kShiftRight;
    case Operation::kBitAnd: return IntegerOperation::kAnd;
    case Operation::kBitOr: return IntegerOperation::kOr;
    case Operation::kBitXor: return IntegerOperation::kXor;
    default: return std::nullopt;
  }
}

}  // namespace

Value Evaluator::unsupported(Operation operation, Value a, Value b) {
  return wrong_type("no operation " + std::string(type_name(a)) + ' ' +
                    std::string(to_string(operation)) + ' ' + std::string(type_name(b)));
}

Value Evaluator::binary(Operation operation, Value a, Value b) {
  if (a.is_text() && operation == Operation::kModulo) {
    const auto formatted = format_percent(*this, a.as_text(), b);
    return formatted ? text(*formatted) : Value::error();
  }
  if (a.is_number() && b.is_number()) {
    if (a.is_integral() && b.is_integral()) return integer_binary(operation, a, b);
    const double x = as_real(a);
    const double y = as_real(b);
    if ((std::isinf(x) && !a.is(Type::kReal)) || (std::isinf(y) && !b.is(Type::kReal))) {
      return wrong_value("the number is too large for a real number");
    }
    return real_binary(operation, x, y);
  }
  if (a.is_set() && b.is_set()) return set_binary(operation, a, b);
  if (a.is(Type::kDictionary) && b.is(Type::kDictionary) && operation == Operation::kBitOr) {
    Entries both = *a.dictionary_->entries;
    both.shared = false;
    for (const Entry& entry : b.dictionary_->entries->list) {
      set_entry(both, entry.key, entry.value, entry.place);
    }
    return heap_.entries(Type::kDictionary, std::move(both));
  }
  return sequence_binary(operation, a, b);
}

Value Evaluator::integer_binary(Operation operation, Value a, Value b) {
  const bool bits = operation == Operation::kBitAnd || operation == Operation::kBitOr ||
                    operation == Operation::kBitXor;
  if (bits && a.is(Type::kBool) && b.is(Type::kBool)) {
    const Value r = integer_operation(heap_, *integer_operation_for(operation), a, b);
    return Value::boolean(r.integer_ != 0);
  }
  const bool divides = operation == Operation::kDivide || operation == Operation::kFloorDivide ||
                       operation == Operation::kModulo;
  if (divides && is_zero_integer(b)) return fail(FactKind::kDivisionByZero, {});
  if (operation == Operation::kDivide) {
    const double quotient = true_quotient(a, b);
    if (std::isinf(quotient)) return wrong_value("the quotient is too large for a real number");
    return Value::real(quotient);
  }
  if (operation == Operation::kPower && is_negative_integer(b)) {
    if (is_zero_integer(a)) return fail(FactKind::kDivisionByZero, {});
    return real_binary(operation, integer_to_double(a), integer_to_double(b));
  }
  const bool shifts = operation == Operation::kShiftLeft || operation == Operation::kShiftRight;
  if (shifts && is_negative_integer(b)) return wrong_value("a shift by a negative count");
  const std::optional<IntegerOperation> exact = integer_operation_for(operation);
  if (!exact) return unsupported(operation, a, b);
  if (!a.is_small() || !b.is_small() || operation == Operation::kPower) {
    // Long numbers take the square of their length.
    if (!work(10 + integer_bits(a) * integer_bits(b) / 4096)) return Value::error();
  }
  return number(integer_operation(heap_, *exact, a, b));
}

Value Evaluator::real_binary(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::kAdd: return Value::real(a + b);
    case Operation::kSubtract: return Value::real(a - b);
    case Operation::kMultiply: return Value::real(a * b);
    case Operation::kDivide:
      if (b == 0) return fail(FactKind::kDivisionByZero, {});
      return Value::real(a / b);
    case Operation::kFloorDivide:
      if (b == 0) return fail(FactKind::kDivisionByZero, {});
      return Value::real(real_floor_quotient(a, b));
    case Operation::kModulo:
      if (b == 0) return fail(FactKind::kDivisionByZero, {});
      return Value::real(real_modulo(a, b));
    case Operation::kPower: {
      if (a == 0 && b < 0) return fail(FactKind::kDivisionByZero, {});
      if (a < 0 && std::isfinite(a) && std::isfinite(b) && b != std::floor(b)) {
        return fail(FactKind::kOutsideLanguage, {},
                    "complex numbers, as a root of a negative number is");
      }
      const double power = std::pow(a, b);
      if (std::isinf(power) && std::isfinite(a) && std::isfinite(b)) {
        return wrong_value("the power is too large for a real number");
      }
      return Value::real(power);
    }
    default: return unsupported(operation, Value::real(a), Value::real(b));
  }
}

Value Evaluator::set_binary(Operation operation, Value a, Value b) {
  const Entries& x = *a.dictionary_->entries;
  const Entries& y = *b.dictionary_->entries;
  if (!work(x.list.size() + y.list.size())) return Value::error();
  Entries result;
  const bool keeps_common = operation == Operation::kBitAnd;
  for (const Entry& entry : x.list) {
    if (operation == Operation::kBitOr || (find_entry(y, entry.key) != nullptr) == keeps_common) {
      set_entry(result, entry.key, Value::none());
    }
  }
  switch (operation) {
    case Operation::kBitAnd:
    case Operation::kSubtract: break;
    case Operation::kBitOr:
    case Operation::kBitXor:
      for (const Entry& entry : y.list) {
        if (operation == Operation::kBitOr || find_entry(x, entry.key) == nullptr) {
          set_entry(result, entry.key, Value::none());
        }
      }
      break;
    default: return unsupported(operation, a, b);
  }
  return heap_.entries(a.type, std::move(result));
}

Value Evaluator::sequence_binary(Operation operation, Value a, Value b) {
  if (operation == Operation::kAdd && a.type == b.type) {
    if (a.is_text()) {
      std::string both(a.as_text());
      return text(both += b.as_text());
    }
    if (a.is_sequence()) {
      if (!fits(a.sequence_->items->values.size() + b.sequence_->items->values.size()))
        return Value::error();
      std::vector<Value> both = a.sequence_->items->values;
      const std::vector<Value>& more = b.sequence_->items->values;
      both.insert(both.end(), more.begin(), more.end());
      return heap_.sequence(a.type, std::move(both));
    }
  }
  if (operation == Operation::kMultiply) {
    if (a.is_integral()) std::swap(a, b);
    if (b.is_integral() && (a.is_text() || a.is_sequence())) {
      const auto most = static_cast<std::int64_t>(bounds_.text_bytes) + 1;
      const std::int64_t times = is_negative_integer(b) ? 0
                                 : b.is_small()         ? std::min(b.integer_, most)
                                                        : most;
      const auto count = static_cast<std::uint64_t>(times);
      if (a.is_text()) {
        if (a.size * count > bounds_.text_bytes)
          return fail(FactKind::kBoundReached, {}, "the length of a text");
        std::string repeated;
        for (std::uint64_t i = 0; i < (a.size == 0 ? 0 : count); ++i) repeated += a.as_text();
        return text(repeated);
      }
      const std::vector<Value>& items = a.sequence_->items->values;
      if (!fits(items.size() * count)) return Value::error();
      std::vector<Value> repeated;
      for (std::uint64_t i = 0; i < (items.empty() ? 0 : count); ++i) {
        repeated.insert(repeated.end(), items.begin(), items.end());
      }
      return heap_.sequence(a.type, std::move(repeated));
    }
  }
  return unsupported(operation, a, b);
}

Value Evaluator::contains(Value item, Value in) {
  if (in.is_text()) {
    if (!item.is_text())
      return wrong_type("'in <text>' takes a text, not " + std::string(type_name(item)));
    if (!work(1 + in.size / 64)) return Value::error();
    return Value::boolean(in.as_text().find(item.as_text()) != std::string_view::npos);
  }
  if (in.is(Type::kDictionary) || in.is_set()) {
    if (!is_hashable(item))
      return wrong_type("unhashable type: '" + std::string(type_name(item)) + "'");
    return Value::boolean(find_entry(*in.dictionary_->entries, item) != nullptr);
  }
  const auto items = items_of(in);
  if (!items) return Value::error();
  for (const Value other : *items) {
    if (!work(1)) return Value::error();
    if (are_identical(item, other) || are_equal(item, other).value_or(false))
      return Value::boolean(true);
  }
  return Value::boolean(false);
}

Value Evaluator::compare(Operation operation, Value a, Value b) {
  const auto subset = [](Value x, Value y) {
    for (const Entry& entry : x.dictionary_->entries->list) {
      if (find_entry(*y.dictionary_->entries, entry.key) == nullptr) return false;
    }
    return true;
  };
  switch (operation) {
    case Operation::kIn:
    case Operation::kNotIn: {
      const Value found = contains(a, b);
      if (found.failed() || operation == Operation::kIn) return found;
      return Value::boolean(!is_true(found));
    }
    case Operation::kIs:
    case Operation::kIsNot:
      return Value::boolean(are_identical(a, b) == (operation == Operation::kIs));
    case Operation::kEqual:
    case Operation::kNotEqual: {
      const std::optional<bool> same = are_equal(a, b);
      if (!same) return fail(FactKind::kBoundReached, {}, "the depth of a list");
      return Value::boolean(*same == (operation == Operation::kEqual));
    }
    default: break;
  }
  if (a.is_set() && b.is_set()) {
    const bool less = operation == Operation::kLess || operation == Operation::kLessEqual;
    const bool strict = operation == Operation::kLess || operation == Operation::kGreater;
    const bool within = less ? subset(a, b) : subset(b, a);
    const bool same_size =
        a.dictionary_->entries->list.size() == b.dictionary_->entries->list.size();
    return Value::boolean(within && !(strict && same_size));
  }
  const Order order = order_of(a, b);
  switch (order) {
    case Order::kUnordered: return Value::boolean(false);
    case Order::kIncomparable: return unsupported(operation, a, b);
    case Order::kLess:
      return Value::boolean(operation == Operation::kLess || operation == Operation::kLessEqual);
    case Order::kGreater:
      return Value::boolean(operation == Operation::kGreater ||
                            operation == Operation::kGreaterEqual);
    case Order::kEqual: break;
  }
  return Value::boolean(operation == Operation::kLessEqual ||
                        operation == Operation::kGreaterEqual);
}

}  // namespace rigor::xacro
