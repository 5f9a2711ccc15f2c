// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The module `python` of the expression language: the builtins that the reference exposes.

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/format.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/number_text.h>
#include <rigor/xacro/value/ordering.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

Value python_list(Evaluator& e, Value, Arguments& a) {
  if (!a.has(0)) return e.list({});
  auto items = e.items_of(a.values[0]);
  return items ? e.list(std::move(*items)) : Value::error();
}

Value python_tuple(Evaluator& e, Value, Arguments& a) {
  if (!a.has(0)) return e.heap().tuple({});
  auto items = e.items_of(a.values[0]);
  return items && e.fits(items->size()) ? e.heap().tuple(std::move(*items)) : Value::error();
}

template <Type T>
Value python_set(Evaluator& e, Value, Arguments& a) {
  Entries entries;
  if (a.has(0)) {
    const auto items = e.items_of(a.values[0]);
    if (!items) return Value::error();
    for (const Value item : *items) {
      if (!is_hashable(item))
        return e.wrong_type("unhashable type: '" + std::string(type_name(item)) + "'");
      set_entry(entries, item, Value::none());
    }
  }
  return e.heap().entries(T, std::move(entries));
}

Value python_dict(Evaluator& e, Value, Arguments& a) {
  Entries entries;
  if (a.has(0) && a.values[0].is(Type::kDictionary)) {
    entries = *a.values[0].dictionary_->entries;
    entries.shared = false;
  } else if (a.has(0)) {
    const auto pairs = e.items_of(a.values[0]);
    if (!pairs) return Value::error();
    for (const Value pair : *pairs) {
      const auto parts = e.items_of(pair);
      if (!parts) return Value::error();
      if (parts->size() != 2) return e.wrong_value("a dictionary is made of pairs");
      if (!is_hashable((*parts)[0]))
        return e.wrong_type("unhashable type: '" + std::string(type_name((*parts)[0])) + "'");
      set_entry(entries, (*parts)[0], (*parts)[1]);
    }
  }
  for (const auto& [name, value] : a.named) set_entry(entries, Value::text(name), value);
  return e.heap().entries(Type::kDictionary, std::move(entries));
}

Value python_str(Evaluator& e, Value, Arguments& a) {
  if (!a.has(0)) return Value::text({});
  if (a.values[0].is_text()) return a.values[0];
  const auto text = e.text_of(a.values[0]);
  return text ? e.text(*text) : Value::error();
}

Value python_repr(Evaluator& e, Value, Arguments& a) {
  const auto text = e.repr_of(a.values[0]);
  return text ? e.text(*text) : Value::error();
}

std::string shown(Evaluator& e, Value v) { return e.repr_of(v).value_or("?"); }

Value python_int(Evaluator& e, Value, Arguments& a) {
  const Value v = a.get(0, Value::integer(0));
  if (v.is_text()) {
    const Value base = a.find("base").value_or(a.get(1, Value::integer(10)));
    const int b = base.is_small() && base.integer_ >= 0 && base.integer_ <= 36
                      ? static_cast<int>(base.integer_)
                      : -1;
    const Value n = integer_from_text(e.heap(), v.as_text(), b);
    return n.failed() ? e.wrong_value("int() takes no " + shown(e, v)) : n;
  }
  if (v.is_integral()) return v.is(Type::kBool) ? Value::integer(v.integer_) : v;
  if (!v.is(Type::kReal))
    return e.wrong_type("int() takes a number or text, not " + std::string(type_name(v)));
  if (!std::isfinite(v.real_)) return e.wrong_value("int() takes no " + real_to_text(v.real_));
  return e.number(integer_from_double(e.heap(), std::trunc(v.real_)));
}

Value python_float(Evaluator& e, Value, Arguments& a) {
  const Value v = a.get(0, Value::real(0));
  if (v.is(Type::kReal)) return v;
  if (v.is_text()) {
    const auto d = real_from_text(v.as_text());
    return d ? Value::real(*d) : e.wrong_value("float() takes no " + shown(e, v));
  }
  if (!v.is_integral())
    return e.wrong_type("float() takes a number or text, not " + std::string(type_name(v)));
  const double d = integer_to_double(v);
  return std::isinf(d) ? e.wrong_value("the number is too large for a real number")
                       : Value::real(d);
}

Value python_bool(Evaluator&, Value, Arguments& a) {
  return Value::boolean(a.has(0) && is_true(a.values[0]));
}

Value python_len(Evaluator& e, Value, Arguments& a) {
  const Value v = a.values[0];
  const auto size = [](std::size_t n) { return Value::integer(static_cast<std::int64_t>(n)); };
  switch (v.type) {
    case Type::kText: return size(code_points(v.as_text()));
    case Type::kList:
    case Type::kTuple: return size(v.sequence_->items->values.size());
    case Type::kDictionary:
    case Type::kSet:
    case Type::kFrozenSet: return size(v.dictionary_->entries->list.size());
    case Type::kRange: return Value::integer(range_size(*v.iterator_));
    case Type::kView: return size(v.iterator_->values.size());
    default: return e.wrong_type("a " + std::string(type_name(v)) + " has no length");
  }
}

template <bool Largest>
Value extreme(Evaluator& e, Value, Arguments& a) {
  std::vector<Value> items = a.values;
  if (items.size() == 1) {
    auto given = e.items_of(items[0]);
    if (!given) return Value::error();
    items = std::move(*given);
    if (items.empty()) {
      if (const auto otherwise = a.find("default")) return *otherwise;
      return e.wrong_value("the smallest or largest of nothing");
    }
  }
  const auto keys = keys_of(e, items, a.find("key").value_or(Value::none()));
  if (!keys) return Value::error();
  std::size_t best = 0;
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Value better =
        e.compare(Largest ? Operation::kGreater : Operation::kLess, (*keys)[i], (*keys)[best]);
    if (better.failed()) return better;
    if (is_true(better)) best = i;
  }
  return items[best];
}

Value python_round(Evaluator& e, Value, Arguments& a) {
  const Value v = a.values[0];
  const Value digits = a.find("ndigits").value_or(a.get(1));
  if (!v.is_number())
    return e.wrong_type("round() takes a number, not " + std::string(type_name(v)));
  if (!digits.is(Type::kNone) && !digits.is_small())
    return e.wrong_type("round() takes a whole number of digits");
  const auto places = digits.is(Type::kNone)
                          ? 0
                          : static_cast<int>(std::clamp<std::int64_t>(digits.integer_, -400, 400));
  if (v.is(Type::kReal)) {
    if (!digits.is(Type::kNone)) return Value::real(rounded(v.real_, places));
    if (!std::isfinite(v.real_))
      return e.wrong_value("no whole number is near " + real_to_text(v.real_));
    return e.number(integer_from_double(e.heap(), std::nearbyint(v.real_)));
  }
  const Value whole = v.is(Type::kBool) ? Value::integer(v.integer_) : v;
  if (places >= 0) return whole;
  // To tens: half to even.
  const Value unit = e.binary(Operation::kPower, Value::integer(10), Value::integer(-places));
  if (unit.failed()) return unit;
  const Value rest = e.binary(Operation::kModulo, whole, unit);
  Value down = e.binary(Operation::kSubtract, whole, rest);
  const int order = compare_integers(e.binary(Operation::kMultiply, rest, Value::integer(2)), unit);
  const Value quotient = e.binary(Operation::kFloorDivide, down, unit);
  const bool odd = !is_zero_integer(e.binary(Operation::kModulo, quotient, Value::integer(2)));
  if (order > 0 || (order == 0 && odd)) down = e.binary(Operation::kAdd, down, unit);
  return down;
}

Value python_map(Evaluator& e, Value, Arguments& a) {
  std::vector<std::vector<Value>> rows;
  std::size_t size = static_cast<std::size_t>(-1);
  for (std::size_t i = 1; i < a.values.size(); ++i) {
    auto items = e.items_of(a.values[i]);
    if (!items) return Value::error();
    size = std::min(size, items->size());
    rows.push_back(std::move(*items));
  }
  std::vector<Value> results;
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<Value> arguments;
    for (const auto& row : rows) arguments.push_back(row[i]);
    results.push_back(e.call(a.values[0], std::move(arguments)));
    if (results.back().failed()) return results.back();
  }
  return e.heap().iterator(Type::kIterator, std::move(results), "map");
}

Value python_filter(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[1]);
  if (!items) return Value::error();
  std::vector<Value> results;
  for (const Value item : *items) {
    const Value kept = a.values[0].is(Type::kNone) ? item : e.call(a.values[0], {item});
    if (kept.failed()) return kept;
    if (is_true(kept)) results.push_back(item);
  }
  return e.heap().iterator(Type::kIterator, std::move(results), "filter");
}

Value python_zip(Evaluator& e, Value, Arguments& a) {
  std::vector<std::vector<Value>> rows;
  std::size_t size = a.values.empty() ? 0 : static_cast<std::size_t>(-1);
  for (const Value v : a.values) {
    auto items = e.items_of(v);
    if (!items) return Value::error();
    size = std::min(size, items->size());
    rows.push_back(std::move(*items));
  }
  std::vector<Value> results;
  for (std::size_t i = 0; i < size && e.work(1); ++i) {
    std::vector<Value> tuple;
    for (const auto& row : rows) tuple.push_back(row[i]);
    results.push_back(e.heap().tuple(std::move(tuple)));
  }
  return e.heap().iterator(Type::kIterator, std::move(results), "zip");
}

Value python_enumerate(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  Value i = a.find("start").value_or(a.get(1, Value::integer(0)));
  std::vector<Value> results;
  for (const Value item : *items) {
    results.push_back(e.heap().tuple({i, item}));
    i = e.binary(Operation::kAdd, i, Value::integer(1));
    if (i.failed()) return i;
  }
  return e.heap().iterator(Type::kIterator, std::move(results), "enumerate");
}

Value python_reversed(Evaluator& e, Value, Arguments& a) {
  if (a.values[0].is_set() || a.values[0].is(Type::kIterator)) {
    return e.wrong_type("a " + std::string(type_name(a.values[0])) + " cannot be reversed");
  }
  auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  std::reverse(items->begin(), items->end());
  return e.heap().iterator(Type::kIterator, std::move(*items), "reversed");
}

Value python_range(Evaluator& e, Value, Arguments& a) {
  // Within 61 bits, so that distances fit 64.
  constexpr std::int64_t kFar = std::int64_t{1} << 61U;
  for (const Value v : a.values) {
    if (!v.is_integral())
      return e.wrong_type("range() takes whole numbers, not " + std::string(type_name(v)));
    if (!v.is_small() || v.integer_ > kFar || v.integer_ < -kFar) return e.number(Value::error());
  }
  const auto part = [&a](std::size_t i, std::int64_t otherwise) {
    return Value::integer(a.has(i) ? a.values[i].integer_ : otherwise);
  };
  const bool single = a.values.size() == 1;
  const Value step = part(2, 1);
  if (step.integer_ == 0) return e.wrong_value("range() takes no step of 0");
  return e.heap().iterator(Type::kRange,
                           {single ? Value::integer(0) : part(0, 0), part(single ? 0 : 1, 0), step},
                           "range");
}

Value python_sorted(Evaluator& e, Value, Arguments& a) {
  auto items = e.items_of(a.values[0]);
  if (!items || !sort_values(e, *items, a)) return Value::error();
  return e.list(std::move(*items));
}

Value python_abs(Evaluator& e, Value, Arguments& a) {
  const Value v = a.values[0];
  if (v.is(Type::kReal)) return Value::real(std::fabs(v.real_));
  if (!v.is_integral())
    return e.wrong_type("abs() takes a number, not " + std::string(type_name(v)));
  if (is_negative_integer(v)) return e.number(negated_integer(e.heap(), v));
  return v.is(Type::kBool) ? Value::integer(v.integer_) : v;
}

template <bool All>
Value all_or_any(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  for (const Value item : *items) {
    if (is_true(item) != All) return Value::boolean(!All);
  }
  return Value::boolean(All);
}

Value python_divmod(Evaluator& e, Value, Arguments& a) {
  const Value quotient = e.binary(Operation::kFloorDivide, a.values[0], a.values[1]);
  if (quotient.failed()) return quotient;
  const Value rest = e.binary(Operation::kModulo, a.values[0], a.values[1]);
  return rest.failed() ? rest : e.heap().tuple({quotient, rest});
}

Value python_hash(Evaluator& e, Value, Arguments& a) {
  const Value v = a.values[0];
  // Python takes hashes modulo 2^61 - 1, and keeps -1 for itself.
  constexpr std::int64_t kHashModulus = (std::int64_t{1} << 61U) - 1;
  if (v.is_small() && v.integer_ < kHashModulus && v.integer_ > -kHashModulus) {
    return Value::integer(v.integer_ == -1 ? -2 : v.integer_);
  }
  return e.fail(FactKind::kOutsideLanguage, {},
                "hash() of other than small numbers, which differs from run to run");
}

bool is_instance(Value v, std::string_view type) {
  if (v.is(Type::kBool) && type == "int") return true;
  if (v.is(Type::kList)) return type == "list";
  if (v.is(Type::kDictionary)) return type == "dict";
  return type_name(v) == type;
}

Value python_isinstance(Evaluator& e, Value, Arguments& a) {
  const Value types = a.values[1];
  std::vector<Value> list{types};
  if (types.is(Type::kTuple)) list = types.sequence_->items->values;
  bool found = false;
  for (const Value type : list) {
    if (!type.is(Type::kClass))
      return e.wrong_type("isinstance() takes a type or a tuple of types");
    found = found || is_instance(a.values[0], type.function_->name);
  }
  return Value::boolean(found);
}

Value python_issubclass(Evaluator& e, Value, Arguments& a) {
  if (!a.values[0].is(Type::kClass) || !a.values[1].is(Type::kClass))
    return e.wrong_type("issubclass() takes types");
  const std::string_view one = a.values[0].function_->name;
  const std::string_view other = a.values[1].function_->name;
  return Value::boolean(one == other || (one == "bool" && other == "int"));
}

Value python_ord(Evaluator& e, Value, Arguments& a) {
  if (!a.values[0].is_text() || code_points(a.values[0].as_text()) != 1)
    return e.wrong_type("ord() takes a text of one character");
  std::size_t at = 0;
  return Value::integer(next_code_point(a.values[0].as_text(), at));
}

Value python_slice(Evaluator& e, Value, Arguments& a) {
  std::vector<Value> parts{a.has(1) ? a.values[0] : Value::none(),
                           a.has(1) ? a.values[1] : a.values[0], a.get(2)};
  return e.heap().iterator(Type::kSlice, std::move(parts), "slice");
}

Value python_sum(Evaluator& e, Value, Arguments& a) {
  const auto items = e.items_of(a.values[0]);
  if (!items) return Value::error();
  Value sum = a.find("start").value_or(a.get(1, Value::integer(0)));
  if (sum.is_text()) return e.wrong_type("sum() takes no texts: use ''.join()");
  for (const Value item : *items) {
    sum = e.binary(Operation::kAdd, sum, item);
    if (sum.failed()) break;
  }
  return sum;
}

Value python_type(Evaluator& e, Value, Arguments& a) {
  for (const Function& type : kPythonModule.classes) {
    if (type.name == type_name(a.values[0])) return Value::function(type, Type::kClass);
  }
  return e.fail(FactKind::kOutsideLanguage, {},
                "the type of a " + std::string(type_name(a.values[0])));
}

Value python_complex(Evaluator& e, Value, Arguments&) {
  return e.fail(FactKind::kOutsideLanguage, {}, "complex numbers");
}

constexpr Function kPythonClasses[] = {
    {"bool", python_bool, 0, 1},           {"dict", python_dict, 0, 1, "*"},
    {"float", python_float, 0, 1},         {"frozenset", python_set<Type::kFrozenSet>, 0, 1},
    {"int", python_int, 0, 2, "base"},     {"list", python_list, 0, 1},
    {"set", python_set<Type::kSet>, 0, 1}, {"str", python_str, 0, 1},
    {"tuple", python_tuple, 0, 1}};

constexpr Function kPythonFunctions[] = {{"abs", python_abs, 1, 1},
                                         {"all", all_or_any<true>, 1, 1},
                                         {"any", all_or_any<false>, 1, 1},
                                         {"complex", python_complex, 0, 2},
                                         {"divmod", python_divmod, 2, 2},
                                         {"enumerate", python_enumerate, 1, 2, "start"},
                                         {"filter", python_filter, 2, 2},
                                         {"hash", python_hash, 1, 1},
                                         {"isinstance", python_isinstance, 2, 2},
                                         {"issubclass", python_issubclass, 2, 2},
                                         {"len", python_len, 1, 1},
                                         {"map", python_map, 2, kAnyCount},
                                         {"max", extreme<true>, 1, kAnyCount, "key default"},
                                         {"min", extreme<false>, 1, kAnyCount, "key default"},
                                         {"ord", python_ord, 1, 1},
                                         {"range", python_range, 1, 3},
                                         {"repr", python_repr, 1, 1},
                                         {"reversed", python_reversed, 1, 1},
                                         {"round", python_round, 1, 2, "ndigits"},
                                         {"slice", python_slice, 1, 3},
                                         {"sorted", python_sorted, 1, 1, "key reverse"},
                                         {"sum", python_sum, 1, 2, "start"},
                                         {"type", python_type, 1, 1},
                                         {"zip", python_zip, 0, kAnyCount}};

}  // namespace

const Module kPythonModule{"python", kPythonClasses, kPythonFunctions, {}};

const Function* function_named(std::span<const Function> functions, std::string_view name) {
  for (const Function& function : functions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

std::optional<Value> member_of(const Module& module, std::string_view name) {
  if (const Function* f = function_named(module.classes, name))
    return Value::function(*f, Type::kClass);
  if (const Function* f = function_named(module.functions, name)) return Value::function(*f);
  for (const Constant& constant : module.constants) {
    if (constant.name == name) return Value::real(constant.value);
  }
  if (module.name == "python" && (name == "True" || name == "False"))
    return Value::boolean(name == "True");
  return std::nullopt;
}

}  // namespace rigor::xacro
