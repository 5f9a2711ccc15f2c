// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The methods of lists, tuples, dictionaries, sets and numbers.

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/ordering.h>

namespace rigor::xacro {
namespace {

std::vector<Value>& own_items(Evaluator& e, Value self) {
  return e.heap().writable(*self.sequence_).values;
}
Entries& own_entries(Evaluator& e, Value self) { return e.heap().writable(*self.dictionary_); }
const std::vector<Value>& items_in(Value self) { return self.sequence_->items->values; }
const Entries& entries_in(Value self) { return *self.dictionary_->entries; }

bool same_value(Value a, Value b) { return are_identical(a, b) || are_equal(a, b).value_or(false); }

bool may_be_key(Evaluator& e, Value key) {
  if (is_hashable(key)) return true;
  e.wrong_type("unhashable type: '" + std::string(type_name(key)) + "'");
  return false;
}

Value list_append(Evaluator& e, Value self, Arguments& a) {
  if (!e.fits(items_in(self).size() + 1)) return Value::error();
  own_items(e, self).push_back(a.values[0]);
  e.heap().charge(sizeof(Value));
  return Value::none();
}

Value list_extend(Evaluator& e, Value self, Arguments& a) {
  const auto more = e.items_of(a.values[0]);
  if (!more || !e.fits(items_in(self).size() + more->size())) return Value::error();
  std::vector<Value>& items = own_items(e, self);
  items.insert(items.end(), more->begin(), more->end());
  e.heap().charge(more->size() * sizeof(Value));
  return Value::none();
}

Value list_insert(Evaluator& e, Value self, Arguments& a) {
  if (!a.values[0].is_small() || !e.fits(items_in(self).size() + 1))
    return e.wrong_type("a whole number is due");
  std::vector<Value>& items = own_items(e, self);
  const auto size = static_cast<std::int64_t>(items.size());
  std::int64_t i = a.values[0].integer_;
  if (i < 0) i = std::max<std::int64_t>(i + size, 0);
  items.insert(items.begin() + std::min(i, size), a.values[1]);
  return Value::none();
}

Value list_pop(Evaluator& e, Value self, Arguments& a) {
  const Value index = a.get(0, Value::integer(-1));
  if (!index.is_small()) return e.wrong_type("a whole number is due");
  const auto size = static_cast<std::int64_t>(items_in(self).size());
  const std::int64_t i = index.integer_ < 0 ? index.integer_ + size : index.integer_;
  if (i < 0 || i >= size)
    return e.fail(FactKind::kNoSuchItem, std::to_string(index.integer_), "there is no item to pop");
  std::vector<Value>& items = own_items(e, self);
  const Value item = items[static_cast<std::size_t>(i)];
  items.erase(items.begin() + i);
  return item;
}

Value list_remove(Evaluator& e, Value self, Arguments& a) {
  std::vector<Value>& items = own_items(e, self);
  const auto found =
      std::find_if(items.begin(), items.end(), [&](Value v) { return same_value(v, a.values[0]); });
  if (found == items.end()) return e.wrong_value("the item is not in the list");
  items.erase(found);
  return Value::none();
}

Value list_clear(Evaluator& e, Value self, Arguments&) {
  own_items(e, self).clear();
  return Value::none();
}
Value list_copy(Evaluator& e, Value self, Arguments&) { return e.list(items_in(self)); }
Value list_reverse(Evaluator& e, Value self, Arguments&) {
  std::vector<Value>& items = own_items(e, self);
  std::reverse(items.begin(), items.end());
  return Value::none();
}
Value list_sort(Evaluator& e, Value self, Arguments& a) {
  std::vector<Value> items = items_in(self);
  if (!sort_values(e, items, a)) return Value::error();
  own_items(e, self) = std::move(items);
  return Value::none();
}

Value sequence_count(Evaluator&, Value self, Arguments& a) {
  const auto& items = items_in(self);
  return Value::integer(std::count_if(items.begin(), items.end(),
                                      [&](Value v) { return same_value(v, a.values[0]); }));
}
Value sequence_index(Evaluator& e, Value self, Arguments& a) {
  const auto& items = items_in(self);
  const auto found =
      std::find_if(items.begin(), items.end(), [&](Value v) { return same_value(v, a.values[0]); });
  if (found == items.end()) return e.wrong_value("the item is not in it");
  return Value::integer(found - items.begin());
}

constexpr Function kTupleMethods[] = {{"count", sequence_count, 1, 1},
                                      {"index", sequence_index, 1, 1}};
constexpr Function kListMethods[] = {{"append", list_append, 1, 1},
                                     {"clear", list_clear, 0, 0},
                                     {"copy", list_copy, 0, 0},
                                     {"count", sequence_count, 1, 1},
                                     {"extend", list_extend, 1, 1},
                                     {"index", sequence_index, 1, 1},
                                     {"insert", list_insert, 2, 2},
                                     {"pop", list_pop, 0, 1},
                                     {"remove", list_remove, 1, 1},
                                     {"reverse", list_reverse, 0, 0},
                                     {"sort", list_sort, 0, 0, "key reverse"}};

enum class Part : std::uint8_t { kKeys, kValues, kItems };

template <Part P>
Value dictionary_view(Evaluator& e, Value self, Arguments&) {
  std::vector<Value> values;
  if (!e.fits(entries_in(self).list.size())) return Value::error();
  for (const Entry& entry : entries_in(self).list) {
    values.push_back(P == Part::kKeys     ? entry.key
                     : P == Part::kValues ? entry.value
                                          : e.heap().tuple({entry.key, entry.value}));
  }
  constexpr std::string_view kNames[] = {"dict_keys", "dict_values", "dict_items"};
  return e.heap().iterator(Type::kView, std::move(values), kNames[static_cast<int>(P)]);
}

Value dictionary_get(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0])) return Value::error();
  const Entry* entry = find_entry(entries_in(self), a.values[0]);
  if (entry != nullptr && !entry->place.nowhere()) e.host().used(entry->place);
  return entry != nullptr ? entry->value : a.get(1);
}

Value dictionary_pop(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0])) return Value::error();
  const Entry* entry = find_entry(entries_in(self), a.values[0]);
  if (entry == nullptr) {
    if (a.has(1)) return a.values[1];
    return e.fail(FactKind::kNoSuchItem, e.repr_of(a.values[0]).value_or("?"),
                  "the dictionary has no such key to pop");
  }
  const Value value = entry->value;
  erase_entry(own_entries(e, self), a.values[0]);
  return value;
}

Value dictionary_popitem(Evaluator& e, Value self, Arguments&) {
  if (entries_in(self).list.empty())
    return e.fail(FactKind::kNoSuchItem, {}, "the dictionary is empty");
  const Entry last = entries_in(self).list.back();
  erase_entry(own_entries(e, self), last.key);
  return e.heap().tuple({last.key, last.value});
}

Value dictionary_setdefault(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0]) || !e.fits(entries_in(self).list.size() + 1))
    return Value::error();
  if (const Entry* entry = find_entry(entries_in(self), a.values[0])) return entry->value;
  set_entry(own_entries(e, self), a.values[0], a.get(1));
  e.heap().charge(sizeof(Entry));
  return a.get(1);
}

Value dictionary_update(Evaluator& e, Value self, Arguments& a) {
  const Value more = e.call(Value::function(class_named("dict"), Type::kClass), a.values);
  if (more.failed() || !e.fits(entries_in(self).list.size() + entries_in(more).list.size()))
    return Value::error();
  Entries& entries = own_entries(e, self);
  for (const Entry& entry : entries_in(more).list)
    set_entry(entries, entry.key, entry.value, entry.place);
  for (const auto& [name, value] : a.named) set_entry(entries, Value::text(name), value);
  e.heap().charge(entries_in(more).list.size() * sizeof(Entry));
  return Value::none();
}

Value dictionary_copy(Evaluator& e, Value self, Arguments&) {
  Entries copy = entries_in(self);
  copy.shared = false;
  return e.heap().entries(self.type, std::move(copy));
}
Value dictionary_clear(Evaluator& e, Value self, Arguments&) {
  own_entries(e, self) = {};
  return Value::none();
}

constexpr Function kDictionaryMethods[] = {{"clear", dictionary_clear, 0, 0},
                                           {"copy", dictionary_copy, 0, 0},
                                           {"get", dictionary_get, 1, 2},
                                           {"items", dictionary_view<Part::kItems>, 0, 0},
                                           {"keys", dictionary_view<Part::kKeys>, 0, 0},
                                           {"pop", dictionary_pop, 1, 2},
                                           {"popitem", dictionary_popitem, 0, 0},
                                           {"setdefault", dictionary_setdefault, 1, 2},
                                           {"update", dictionary_update, 0, 1, "*"},
                                           {"values", dictionary_view<Part::kValues>, 0, 0}};

Value set_add(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0]) || !e.fits(entries_in(self).list.size() + 1))
    return Value::error();
  set_entry(own_entries(e, self), a.values[0], Value::none());
  e.heap().charge(sizeof(Entry));
  return Value::none();
}
Value set_remove(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0])) return Value::error();
  if (erase_entry(own_entries(e, self), a.values[0])) return Value::none();
  return e.fail(FactKind::kNoSuchItem, e.repr_of(a.values[0]).value_or("?"),
                "the set has no such item");
}
Value set_discard(Evaluator& e, Value self, Arguments& a) {
  if (!may_be_key(e, a.values[0])) return Value::error();
  erase_entry(own_entries(e, self), a.values[0]);
  return Value::none();
}
Value set_pop(Evaluator& e, Value self, Arguments&) {
  if (entries_in(self).list.empty()) return e.fail(FactKind::kNoSuchItem, {}, "the set is empty");
  const Value first = entries_in(self).list.front().key;
  erase_entry(own_entries(e, self), first);
  return first;
}

/// An argument of a set's method as a set.
Value as_set(Evaluator& e, Value v) {
  return v.is_set() ? v : e.call(Value::function(class_named("set"), Type::kClass), {v});
}

template <Operation O>
Value set_combined(Evaluator& e, Value self, Arguments& a) {
  Value result = self;
  for (const Value v : a.values) {
    const Value other = as_set(e, v);
    if (other.failed()) return other;
    result = e.binary(O, result, other);
    if (result.failed()) return result;
  }
  return result.dictionary_ == self.dictionary_ ? dictionary_copy(e, self, a) : result;
}

Value set_update(Evaluator& e, Value self, Arguments& a) {
  const Value all = set_combined<Operation::kBitOr>(e, self, a);
  if (all.failed()) return all;
  own_entries(e, self) = entries_in(all);
  return Value::none();
}

template <Operation O>
Value set_compared(Evaluator& e, Value self, Arguments& a) {
  const Value other = as_set(e, a.values[0]);
  return other.failed() ? other : e.compare(O, self, other);
}

Value set_isdisjoint(Evaluator& e, Value self, Arguments& a) {
  const Value common = set_combined<Operation::kBitAnd>(e, self, a);
  return common.failed() ? common : Value::boolean(!is_true(common));
}

constexpr Function kSetMethods[] = {
    {"add", set_add, 1, 1},
    {"clear", dictionary_clear, 0, 0},
    {"copy", dictionary_copy, 0, 0},
    {"difference", set_combined<Operation::kSubtract>, 0, kAnyCount},
    {"discard", set_discard, 1, 1},
    {"intersection", set_combined<Operation::kBitAnd>, 0, kAnyCount},
    {"isdisjoint", set_isdisjoint, 1, 1},
    {"issubset", set_compared<Operation::kLessEqual>, 1, 1},
    {"issuperset", set_compared<Operation::kGreaterEqual>, 1, 1},
    {"pop", set_pop, 0, 0},
    {"remove", set_remove, 1, 1},
    {"symmetric_difference", set_combined<Operation::kBitXor>, 1, 1},
    {"union", set_combined<Operation::kBitOr>, 0, kAnyCount},
    {"update", set_update, 0, kAnyCount}};

Value number_bit_length(Evaluator& e, Value self, Arguments&) {
  if (!self.is_integral()) return e.wrong_type("a float has no bit_length");
  return Value::integer(static_cast<std::int64_t>(integer_bits(self)));
}
Value number_is_integer(Evaluator& e, Value self, Arguments&) {
  if (!self.is(Type::kReal)) return e.wrong_type("an int has no is_integer");
  return Value::boolean(std::isfinite(self.real_) && std::floor(self.real_) == self.real_);
}
Value number_conjugate(Evaluator&, Value self, Arguments&) { return self; }

constexpr Function kNumberMethods[] = {{"bit_length", number_bit_length, 0, 0},
                                       {"conjugate", number_conjugate, 0, 0},
                                       {"is_integer", number_is_integer, 0, 0}};

}  // namespace

const Function& class_named(std::string_view name) {
  return *function_named(kPythonModule.classes, name);
}

const Function* list_method(std::string_view name) { return function_named(kListMethods, name); }
const Function* tuple_method(std::string_view name) { return function_named(kTupleMethods, name); }
const Function* dictionary_method(std::string_view name) {
  return function_named(kDictionaryMethods, name);
}
const Function* set_method(std::string_view name) { return function_named(kSetMethods, name); }
const Function* number_method(std::string_view name) {
  return function_named(kNumberMethods, name);
}

const Function* method_of(Value self, std::string_view name) {
  switch (self.type) {
    case Type::kText: return text_method(name);
    case Type::kList: return list_method(name);
    case Type::kTuple: return tuple_method(name);
    case Type::kDictionary: return dictionary_method(name);
    case Type::kSet:
    case Type::kFrozenSet: return set_method(name);
    default: return self.is_number() ? number_method(name) : nullptr;
  }
}

}  // namespace rigor::xacro
