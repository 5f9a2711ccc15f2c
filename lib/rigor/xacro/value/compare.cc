// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/compare.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include <rigor/xacro/bounds.h>
#include <rigor/xacro/expression/function.h>
#include <rigor/xacro/value/integer.h>

namespace rigor::xacro {
namespace {

/// Below it a walk over all entries is faster than an index.
constexpr std::size_t kIndexedEntries = 12;

std::optional<bool> equal_within(Value a, Value b, std::uint32_t depth);

std::optional<bool> equal_items(const std::vector<Value>& a, const std::vector<Value>& b,
                                std::uint32_t depth) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::optional<bool> same = equal_within(a[i], b[i], depth + 1);
    if (!same || !*same) return same;
  }
  return true;
}

std::optional<bool> equal_entries(const Entries& a, const Entries& b, std::uint32_t depth) {
  if (a.list.size() != b.list.size()) return false;
  for (const Entry& entry : a.list) {
    const Entry* other = find_entry(b, entry.key);
    if (other == nullptr) return false;
    const std::optional<bool> same = equal_within(entry.value, other->value, depth + 1);
    if (!same || !*same) return same;
  }
  return true;
}

bool equal_numbers(Value a, Value b) {
  if (a.is_integral() && b.is_integral()) return compare_integers(a, b) == 0;
  if (a.is(Type::kReal) && b.is(Type::kReal)) return a.real_ == b.real_;
  const Value whole = a.is(Type::kReal) ? b : a;
  const double d = a.is(Type::kReal) ? a.real_ : b.real_;
  return !std::isnan(d) && compare_integer_to_double(whole, d) == 0;
}

std::optional<bool> equal_within(Value a, Value b, std::uint32_t depth) {
  if (depth > kMaxValueDepth) return std::nullopt;
  if (a.is_number() && b.is_number()) return equal_numbers(a, b);
  if (a.is_set() && b.is_set())
    return equal_entries(*a.dictionary_->entries, *b.dictionary_->entries, depth);
  if (a.type != b.type) return false;
  switch (a.type) {
    case Type::kNone: return true;
    case Type::kText: return a.as_text() == b.as_text();
    case Type::kList:
    case Type::kTuple:
      if (a.sequence_ == b.sequence_) return true;
      return equal_items(a.sequence_->items->values, b.sequence_->items->values, depth);
    case Type::kDictionary:
      if (a.dictionary_ == b.dictionary_) return true;
      return equal_entries(*a.dictionary_->entries, *b.dictionary_->entries, depth);
    case Type::kRange:
    case Type::kSlice: return equal_items(a.iterator_->values, b.iterator_->values, depth);
    case Type::kClass:
    case Type::kFunction: return a.function_ == b.function_;
    default: return a.integer_ == b.integer_;
  }
}

Order order_of_doubles(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return Order::kUnordered;
  return a < b ? Order::kLess : a > b ? Order::kGreater : Order::kEqual;
}

Order order_from(int sign) {
  return sign < 0 ? Order::kLess : sign > 0 ? Order::kGreater : Order::kEqual;
}

Order order_of_numbers(Value a, Value b) {
  if (a.is_integral() && b.is_integral()) return order_from(compare_integers(a, b));
  if (a.is(Type::kReal) && b.is(Type::kReal)) return order_of_doubles(a.real_, b.real_);
  if (a.is(Type::kReal)) {
    return std::isnan(a.real_) ? Order::kUnordered
                               : order_from(-compare_integer_to_double(b, a.real_));
  }
  return std::isnan(b.real_) ? Order::kUnordered
                             : order_from(compare_integer_to_double(a, b.real_));
}

Order order_within(Value a, Value b, std::uint32_t depth) {
  if (depth > kMaxValueDepth) return Order::kIncomparable;
  if (a.is_number() && b.is_number()) return order_of_numbers(a, b);
  if (a.type != b.type) return Order::kIncomparable;
  if (a.is_text()) return order_from(a.as_text().compare(b.as_text()));
  if (!a.is_sequence()) return Order::kIncomparable;
  const std::vector<Value>& x = a.sequence_->items->values;
  const std::vector<Value>& y = b.sequence_->items->values;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const std::optional<bool> same = equal_within(x[i], y[i], depth + 1);
    if (!same) return Order::kIncomparable;
    if (!*same) return order_within(x[i], y[i], depth + 1);
  }
  return order_from(x.size() < y.size() ? -1 : x.size() > y.size() ? 1 : 0);
}

void index_entries(Entries& entries) {
  entries.index.clear();
  for (std::uint32_t i = 0; i < entries.list.size(); ++i) {
    entries.index.emplace(hash_of(entries.list[i].key), i);
  }
}

bool hashable_within(Value v, std::uint32_t depth) {
  if (v.is(Type::kList) || v.is(Type::kDictionary) || v.is(Type::kSet) || v.is(Type::kSlice))
    return false;
  if (!v.is(Type::kTuple)) return true;
  const std::vector<Value>& items = v.sequence_->items->values;
  return depth < kMaxValueDepth && std::all_of(items.begin(), items.end(), [depth](Value item) {
           return hashable_within(item, depth + 1);
         });
}

bool same_key(Value a, Value b) { return are_identical(a, b) || are_equal(a, b).value_or(false); }

}  // namespace

bool is_true(Value v) {
  switch (v.type) {
    case Type::kError:
    case Type::kNone: return false;
    case Type::kBool:
    case Type::kInteger: return v.integer_ != 0;
    case Type::kReal: return v.real_ != 0;
    case Type::kText: return v.size != 0;
    case Type::kList:
    case Type::kTuple: return !v.sequence_->items->values.empty();
    case Type::kDictionary:
    case Type::kSet:
    case Type::kFrozenSet: return !v.dictionary_->entries->list.empty();
    case Type::kView: return !v.iterator_->values.empty();
    case Type::kRange: return range_size(*v.iterator_) > 0;
    default: return true;
  }
}

std::optional<bool> are_equal(Value a, Value b) { return equal_within(a, b, 0); }

bool are_identical(Value a, Value b) {
  if (a.type != b.type) return false;
  if (a.is_text())
    return a.as_text() == b.as_text();  // Python interns the short ones, which are compared
  if (a.is(Type::kReal))
    return std::bit_cast<std::uint64_t>(a.real_) == std::bit_cast<std::uint64_t>(b.real_);
  return a.is(Type::kNone) || a.integer_ == b.integer_;
}

Order order_of(Value a, Value b) { return order_within(a, b, 0); }

bool is_hashable(Value v) { return hashable_within(v, 0); }

std::uint64_t hash_of(Value v) {
  if (v.is_text()) return std::hash<std::string_view>{}(v.as_text());
  // 1, 1.0 and True are one key.
  if (v.is_integral()) return std::hash<double>{}(integer_to_double(v));
  if (v.is(Type::kReal)) return std::hash<double>{}(v.real_);
  if (v.is(Type::kTuple)) {
    std::uint64_t hash = 0x9E3779B97F4A7C15U;
    for (const Value item : v.sequence_->items->values) hash = hash * 31 + hash_of(item);
    return hash;
  }
  return static_cast<std::uint64_t>(v.type);
}

const Entry* find_entry(const Entries& entries, Value key) {
  if (!is_hashable(key)) return nullptr;
  if (entries.index.empty()) {
    for (const Entry& entry : entries.list) {
      if (same_key(entry.key, key)) return &entry;
    }
    return nullptr;
  }
  const auto [begin, end] = entries.index.equal_range(hash_of(key));
  for (auto it = begin; it != end; ++it) {
    if (same_key(entries.list[it->second].key, key)) return &entries.list[it->second];
  }
  return nullptr;
}

void set_entry(Entries& entries, Value key, Value value, Span place) {
  if (const Entry* found = find_entry(entries, key)) {
    Entry& entry = entries.list[static_cast<std::size_t>(found - entries.list.data())];
    entry.value = value;
    entry.place = place;
    return;
  }
  entries.list.push_back({key, value, place});
  if (!entries.index.empty()) {
    entries.index.emplace(hash_of(key), static_cast<std::uint32_t>(entries.list.size() - 1));
  } else if (entries.list.size() > kIndexedEntries) {
    index_entries(entries);
  }
}

bool erase_entry(Entries& entries, Value key) {
  const Entry* found = find_entry(entries, key);
  if (found == nullptr) return false;
  entries.list.erase(entries.list.begin() + (found - entries.list.data()));
  if (!entries.index.empty()) index_entries(entries);
  return true;
}

std::string_view type_name(Value v) {
  switch (v.type) {
    case Type::kError: return "error";
    case Type::kNone: return "NoneType";
    case Type::kBool: return "bool";
    case Type::kInteger:
    case Type::kBigInteger: return "int";
    case Type::kReal: return "float";
    case Type::kText: return "str";
    case Type::kList: return v.sequence_->dotted ? "YamlListWrapper" : "list";
    case Type::kTuple: return "tuple";
    case Type::kDictionary: return v.dictionary_->dotted ? "YamlDictWrapper" : "dict";
    case Type::kSet: return "set";
    case Type::kFrozenSet: return "frozenset";
    case Type::kRange: return "range";
    case Type::kSlice: return "slice";
    case Type::kIterator:
    case Type::kView: return v.iterator_->name;
    case Type::kFunction:
    case Type::kMethod: return "function";
    case Type::kClass: return "type";
    case Type::kModule:
    case Type::kNamespace: return "NameSpace";
    case Type::kBlock: return "Element";
  }
  return "?";
}

}  // namespace rigor::xacro
