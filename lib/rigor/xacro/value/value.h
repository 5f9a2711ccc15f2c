// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A value of the expression language: sixteen bytes, copied freely. What does not fit in them (texts,
// lists, large numbers) lives in a `Heap` until the expansion ends, so values are never counted or freed,
// and lists are shared as Python shares them.
//
//   Value two = Value::integer(2);
//   Value name = heap.text("base_link");
//   name.as_text();  // valid as long as the heap

#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/text/span.h>

namespace rigor::xacro {

class Scope;
struct Node;
struct BigInteger;
struct Function;
struct Method;
struct Module;
struct Sequence;
struct Dictionary;
struct Iterator;

enum class Type : std::uint8_t {
  kError,  ///< of an expression that failed, which has been reported; spreads in silence
  kNone,
  kBool,
  kInteger,     ///< fits 64 bits
  kBigInteger,  ///< does not
  kReal,
  kText,
  kList,
  kTuple,
  kDictionary,
  kSet,
  kFrozenSet,
  kRange,
  kSlice,
  kIterator,
  kView,  ///< of a dictionary's keys, values or items
  kFunction,
  kMethod,     ///< a function bound to a value
  kClass,      ///< `list`, `str` …: a function that is also a type
  kModule,     ///< `python`, `math`, `xacro`
  kNamespace,  ///< of an include with `ns`
  kBlock,      ///< elements, of a block parameter or property
};

struct Value {
  Type type = Type::kNone;
  std::uint32_t size = 0;  ///< bytes of a text
  union {
    std::int64_t integer_;
    double real_;
    const char* text_;
    const BigInteger* big_;
    Sequence* sequence_;
    Dictionary* dictionary_;
    Iterator* iterator_;
    const Function* function_;
    const Method* method_;
    const Module* module_;
    Scope* scope_;
    const Node* node_;
  };

  Value() : integer_(0) {}
  static Value error() { return of(Type::kError); }
  static Value none() { return {}; }
  static Value boolean(bool b) { return of(Type::kBool, b ? 1 : 0); }
  static Value integer(std::int64_t i) { return of(Type::kInteger, i); }
  static Value real(double d) {
    Value v = of(Type::kReal);
    v.real_ = d;
    return v;
  }
  /// Of bytes that live as long as the heap: literals and what the heap holds.
  static Value text(std::string_view kept) {
    Value v = of(Type::kText);
    v.text_ = kept.data();
    v.size = static_cast<std::uint32_t>(kept.size());
    return v;
  }
  static Value big(const BigInteger& b) {
    Value v = of(Type::kBigInteger);
    v.big_ = &b;
    return v;
  }
  static Value function(const Function& f, Type type = Type::kFunction) {
    Value v = of(type);
    v.function_ = &f;
    return v;
  }
  static Value module(const Module& m) {
    Value v = of(Type::kModule);
    v.module_ = &m;
    return v;
  }
  static Value name_space(Scope& s) {
    Value v = of(Type::kNamespace);
    v.scope_ = &s;
    return v;
  }
  static Value block(const Node& n) {
    Value v = of(Type::kBlock);
    v.node_ = &n;
    return v;
  }

  bool is(Type t) const { return type == t; }
  bool failed() const { return type == Type::kError; }
  bool is_text() const { return type == Type::kText; }
  bool is_sequence() const { return type == Type::kList || type == Type::kTuple; }
  bool is_set() const { return type == Type::kSet || type == Type::kFrozenSet; }
  /// Integers and what counts as one: `True + 1` is 2.
  bool is_integral() const {
    return type == Type::kInteger || type == Type::kBool || type == Type::kBigInteger;
  }
  bool is_number() const { return is_integral() || type == Type::kReal; }
  bool is_small() const { return type == Type::kInteger || type == Type::kBool; }
  std::string_view as_text() const { return {text_, size}; }

 private:
  static Value of(Type type, std::int64_t i = 0) {
    Value v;
    v.type = type;
    v.integer_ = i;
    return v;
  }
};

/// The items of lists and tuples. Lists that YAML made hand out copies of themselves; they share items
/// until one of them changes.
struct Items {
  std::vector<Value> values;
  std::vector<Span> places;  ///< of items from YAML; else empty
  bool shared = false;
};

struct Sequence {
  Items* items;
  bool dotted = false;  ///< from YAML: dictionaries in it take `.key`
};

struct Entry {
  Value key;
  Value value;
  Span place = {};  ///< of a value from YAML
};

/// Entries in the order they were added, as Python's dictionaries and rigor's sets have them.
struct Entries {
  std::vector<Entry> list;
  std::unordered_multimap<std::uint64_t, std::uint32_t> index;  ///< by hash; empty while few
  bool shared = false;
};

struct Dictionary {
  Entries* entries;
  bool dotted = false;
};

/// Ranges and slices have three numbers, iterators values that are taken once.
struct Iterator {
  std::vector<Value> values;
  std::size_t next = 0;
  std::string_view name;  ///< "map", "zip", "dict_keys"
};

struct Method {
  const Function* function;
  Value self;
};

}  // namespace rigor::xacro
