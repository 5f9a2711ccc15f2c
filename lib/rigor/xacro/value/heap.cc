// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/heap.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace rigor::xacro {
namespace {

constexpr std::size_t kHeapChunk = std::size_t{32} << 10U;

}  // namespace

std::string_view Heap::keep(std::string_view bytes) {
  if (bytes.empty()) return {};
  if (bytes.size() > left_) {
    const std::size_t size = std::max(kHeapChunk, bytes.size());
    chunks_.push_back(std::make_unique_for_overwrite<char[]>(size));
    next_ = chunks_.back().get();
    left_ = size;
  }
  std::memcpy(next_, bytes.data(), bytes.size());
  const std::string_view kept(next_, bytes.size());
  next_ += bytes.size();
  left_ -= bytes.size();
  charge(bytes.size());
  return kept;
}

Value Heap::big(BigInteger number) {
  charge(64 + number.bytes());
  return Value::big(numbers_.emplace_back(std::move(number)));
}

Value Heap::sequence(Type type, std::vector<Value> values) {
  charge(sizeof(Items) + sizeof(Sequence) + values.size() * sizeof(Value));
  Value v;
  v.type = type;
  v.sequence_ =
      &sequences_.emplace_back(Sequence{&items_.emplace_back(Items{std::move(values), {}})});
  return v;
}

Value Heap::entries(Type type, Entries entries) {
  charge(sizeof(Entries) + sizeof(Dictionary) + entries.list.size() * sizeof(Entry));
  Value v;
  v.type = type;
  v.dictionary_ =
      &dictionaries_.emplace_back(Dictionary{&entries_.emplace_back(std::move(entries))});
  return v;
}

Value Heap::iterator(Type type, std::vector<Value> values, std::string_view name) {
  charge(sizeof(Iterator) + values.size() * sizeof(Value));
  Value v;
  v.type = type;
  v.iterator_ = &iterators_.emplace_back(Iterator{std::move(values), 0, name});
  return v;
}

Value Heap::method(const Function& function, Value self) {
  charge(sizeof(Method));
  Value v;
  v.type = Type::kMethod;
  v.method_ = &methods_.emplace_back(Method{&function, self});
  return v;
}

Value Heap::wrapped(Value value) {
  if (value.is(Type::kList)) {
    charge(sizeof(Sequence));
    value.sequence_->items->shared = true;
    value.sequence_ = &sequences_.emplace_back(Sequence{value.sequence_->items, true});
  } else if (value.is(Type::kDictionary)) {
    charge(sizeof(Dictionary));
    value.dictionary_->entries->shared = true;
    value.dictionary_ = &dictionaries_.emplace_back(Dictionary{value.dictionary_->entries, true});
  }
  return value;
}

Items& Heap::writable(Sequence& sequence) {
  if (sequence.items->shared) {
    charge(sequence.items->values.size() * sizeof(Value));
    sequence.items = &items_.emplace_back(*sequence.items);
    sequence.items->shared = false;
  }
  // Where an item came from is known as long as none was moved.
  sequence.items->places.clear();
  return *sequence.items;
}

Entries& Heap::writable(Dictionary& dictionary) {
  if (dictionary.entries->shared) {
    charge(dictionary.entries->list.size() * sizeof(Entry));
    dictionary.entries = &entries_.emplace_back(*dictionary.entries);
    dictionary.entries->shared = false;
  }
  return *dictionary.entries;
}

}  // namespace rigor::xacro
