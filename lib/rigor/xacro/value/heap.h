// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the values of an expansion live until it ends. It counts what it gives out, so that no template
// takes the machine's memory: past the bound it is `full()`, and what asked for more fails.

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string_view>
#include <vector>

#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Heap {
 public:
  explicit Heap(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  bool full() const { return used_ > max_bytes_; }
  /// Counts memory that a list in here grows by.
  void charge(std::uint64_t bytes) { used_ += bytes; }

  /// A copy that lives as long as the heap.
  std::string_view keep(std::string_view bytes);
  Value text(std::string_view bytes) { return Value::text(keep(bytes)); }
  Value big(BigInteger number);

  Value list(std::vector<Value> values) { return sequence(Type::kList, std::move(values)); }
  Value tuple(std::vector<Value> values) { return sequence(Type::kTuple, std::move(values)); }
  Value sequence(Type type, std::vector<Value> values);
  Value dictionary() { return entries(Type::kDictionary, {}); }
  Value entries(Type type, Entries entries);
  /// Of type range, slice, iterator or view.
  Value iterator(Type type, std::vector<Value> values, std::string_view name);
  Value method(const Function& function, Value self);

  /// The same list or dictionary as an object of its own; with `.key` when `dotted`.
  Value wrapped(Value value);

  /// For a change: what is shared is copied first.
  Items& writable(Sequence& sequence);
  Entries& writable(Dictionary& dictionary);

 private:
  std::uint64_t max_bytes_;
  std::uint64_t used_ = 0;
  std::vector<std::unique_ptr<char[]>> chunks_;
  char* next_ = nullptr;
  std::size_t left_ = 0;
  std::deque<BigInteger> numbers_;
  std::deque<Items> items_;
  std::deque<Sequence> sequences_;
  std::deque<Entries> entries_;
  std::deque<Dictionary> dictionaries_;
  std::deque<Iterator> iterators_;
  std::deque<Method> methods_;
};

}  // namespace rigor::xacro
