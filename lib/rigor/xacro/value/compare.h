// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Truth, equality, order and hashes of values, and dictionaries, which stand on them.

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap;

/// `bool(v)`.
bool is_true(Value v);

/// `a == b`; nothing where lists nest too deep to say.
std::optional<bool> are_equal(Value a, Value b);

/// `a is b`.
bool are_identical(Value a, Value b);

enum class Order : std::uint8_t {
  kLess,
  kEqual,
  kGreater,
  kUnordered,     ///< a NaN is one of them
  kIncomparable,  ///< of types that have no order
};

/// Of numbers, texts, lists and tuples.
Order order_of(Value a, Value b);

/// Whether it can be a key: no list, dictionary or set, nor a tuple of such.
bool is_hashable(Value v);
std::uint64_t hash_of(Value v);

/// Null where there is none.
const Entry* find_entry(const Entries& entries, Value key);
/// Adds it, or gives the entry of that key another value. The key is hashable.
void set_entry(Entries& entries, Value key, Value value, Span place = {});
/// Whether it was there.
bool erase_entry(Entries& entries, Value key);

/// What Python calls a value's type: "int", "str", "YamlDictWrapper".
std::string_view type_name(Value v);

}  // namespace rigor::xacro
