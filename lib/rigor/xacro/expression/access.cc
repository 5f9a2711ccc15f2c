// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Subscripts, slices, attributes, iteration and calls of `Evaluator`.

#include <algorithm>
#include <limits>
#include <utility>

#include <rigor/xacro/expression/evaluator.h>
#include <rigor/xacro/value/compare.h>
#include <rigor/xacro/value/integer.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

/// Where a slice begins and ends in a row of `size`, as Python's slice.indices has it.
struct SliceBounds {
  std::int64_t begin;
  std::int64_t end;
  std::int64_t step;
};

std::int64_t clamped(Value v, std::int64_t otherwise, std::int64_t size, std::int64_t lowest,
                     std::int64_t highest) {
  if (v.is(Type::kNone)) return otherwise;
  std::int64_t i = v.is_small() ? v.integer_ : is_negative_integer(v) ? -size - 1 : size;
  if (i < 0) i = std::max(i, -size - 1) + size;
  return std::clamp(i, lowest, highest);
}

SliceBounds slice_bounds(const std::vector<Value>& parts, std::int64_t size) {
  std::int64_t step = 1;
  if (parts[2].is_integral()) {
    // A step past the end is as good as any longer one.
    step = parts[2].is_small()             ? std::clamp(parts[2].integer_, -size - 1, size + 1)
           : is_negative_integer(parts[2]) ? -size - 1
                                           : size + 1;
  }
  if (step > 0) {
    return {clamped(parts[0], 0, size, 0, size), clamped(parts[1], size, size, 0, size), step};
  }
  return {clamped(parts[0], size - 1, size, -1, size - 1),
          clamped(parts[1], -1, size, -1, size - 1), step};
}

bool is_index_or_none(Value v) { return v.is(Type::kNone) || v.is_integral(); }

std::string no_attribute(Value of, std::string_view name) {
  return "a " + std::string(type_name(of)) + " has no attribute '" + std::string(name) + "'";
}

}  // namespace

std::int64_t range_size(const Iterator& range) {
  const std::int64_t start = range.values[0].integer_;
  const std::int64_t stop = range.values[1].integer_;
  const std::int64_t step = range.values[2].integer_;
  if (step > 0 ? start >= stop : start <= stop) return 0;
  // Both ends are within 61 bits, so the distance does not overflow.
  return step > 0 ? (stop - start - 1) / step + 1 : (start - stop - 1) / -step + 1;
}

Value Evaluator::slice_of(Value of, Value index) {
  const std::vector<Value>& parts = index.iterator_->values;
  if (!std::all_of(parts.begin(), parts.end(), is_index_or_none)) {
    return wrong_type("slice indices must be whole numbers or None");
  }
  if (parts[2].is_integral() && is_zero_integer(parts[2]))
    return wrong_value("a slice's step is 0");
  const bool is_text = of.is_text();
  if (!is_text && !of.is_sequence()) {
    return wrong_type("a " + std::string(type_name(of)) + " has no slices");
  }
  const auto size = static_cast<std::int64_t>(is_text ? code_points(of.as_text())
                                                      : of.sequence_->items->values.size());
  const SliceBounds bounds = slice_bounds(parts, size);
  if (is_text && bounds.step == 1) {
    if (bounds.begin >= bounds.end) return Value::text({});
    return Value::text(code_point_range(of.as_text(), static_cast<std::size_t>(bounds.begin),
                                        static_cast<std::size_t>(bounds.end)));
  }
  if (!work(static_cast<std::uint64_t>(size))) return Value::error();
  std::string picked;
  std::vector<Value> items;
  // Code points found once, since a step may lead backwards.
  std::vector<std::string_view> points;
  if (is_text) {
    for (std::size_t at = 0; at < of.size;) {
      const std::size_t begin = at;
      next_code_point(of.as_text(), at);
      points.push_back(of.as_text().substr(begin, at - begin));
    }
  }
  for (std::int64_t i = bounds.begin; bounds.step > 0 ? i < bounds.end : i > bounds.end;
       i += bounds.step) {
    const auto at = static_cast<std::size_t>(i);
    if (is_text) {
      picked += points[at];
    } else {
      items.push_back(of.sequence_->items->values[at]);
    }
  }
  if (is_text) return text(picked);
  const Value sliced = heap_.sequence(of.type, std::move(items));
  return of.sequence_->dotted ? heap_.wrapped(sliced) : sliced;
}

Value Evaluator::item_at(Value of, Value index) {
  if (!index.is_integral()) {
    return wrong_type("an index of a " + std::string(type_name(of)) + " is a whole number, not " +
                      std::string(type_name(index)));
  }
  const std::int64_t size = of.is(Type::kRange) ? range_size(*of.iterator_)
                            : of.is_text()
                                ? static_cast<std::int64_t>(code_points(of.as_text()))
                                : static_cast<std::int64_t>(of.sequence_->items->values.size());
  const std::int64_t wanted =
      index.is_small() ? index.integer_ : std::numeric_limits<std::int64_t>::max();
  const std::int64_t i = wanted < 0 ? wanted + size : wanted;
  if (i < 0 || i >= size) {
    return fail(FactKind::kNoSuchItem, std::to_string(wanted),
                "index " + std::to_string(wanted) + " is out of range: there are " +
                    std::to_string(size) + " items");
  }
  const auto at = static_cast<std::size_t>(i);
  if (of.is_text()) return Value::text(code_point_range(of.as_text(), at, at + 1));
  if (of.is(Type::kRange)) {
    return Value::integer(of.iterator_->values[0].integer_ + i * of.iterator_->values[2].integer_);
  }
  const Items& items = *of.sequence_->items;
  if (at < items.places.size()) host_.used(items.places[at]);
  return of.sequence_->dotted ? heap_.wrapped(items.values[at]) : items.values[at];
}

Value Evaluator::subscript(Value of, Value index) {
  if (of.is(Type::kDictionary)) {
    const Dictionary& dictionary = *of.dictionary_;
    if (!is_hashable(index))
      return wrong_type("unhashable type: '" + std::string(type_name(index)) + "'");
    const Entry* entry = find_entry(*dictionary.entries, index);
    if (entry == nullptr) {
      const auto key = repr_of(index);
      if (!key) return Value::error();
      return fail(FactKind::kNoSuchItem, *key, "the dictionary has no key " + *key);
    }
    if (!entry->place.nowhere()) host_.used(entry->place);
    return dictionary.dotted ? heap_.wrapped(entry->value) : entry->value;
  }
  if (index.is(Type::kSlice)) return slice_of(of, index);
  if (of.is_text() || of.is_sequence() || of.is(Type::kRange)) return item_at(of, index);
  if (of.is(Type::kNamespace) && index.is_text()) return attribute(of, index.as_text());
  return wrong_type("a " + std::string(type_name(of)) + " has no items");
}

Value Evaluator::attribute(Value of, std::string_view name) {
  if (of.is(Type::kModule)) {
    if (const auto member = member_of(*of.module_, name)) return *member;
    return fail(FactKind::kUndefinedName, std::string(of.module_->name) + '.' + std::string(name));
  }
  if (of.is(Type::kNamespace)) {
    if (const auto found = host_.look_up(*of.scope_, symbols_.of(name))) return *found;
    return fail(FactKind::kUndefinedName, std::string(name), host_.name_near(*of.scope_, name));
  }
  if (of.is(Type::kClass)) {
    const std::string_view type = of.function_->name;
    const Function* method = type == "str"                          ? text_method(name)
                             : type == "list"                       ? list_method(name)
                             : type == "dict"                       ? dictionary_method(name)
                             : type == "set" || type == "frozenset" ? set_method(name)
                                                                    : nullptr;
    if (method != nullptr) return heap_.method(*method, Value::error());
    return fail(FactKind::kNoSuchItem, std::string(name), no_attribute(of, name));
  }
  if (const Function* method = method_of(of, name)) return heap_.method(*method, of);
  if (of.is(Type::kDictionary) && of.dictionary_->dotted) {
    const Entry* entry = find_entry(*of.dictionary_->entries, Value::text(name));
    if (entry == nullptr) {
      return fail(FactKind::kNoSuchItem, std::string(name),
                  "the YAML dictionary has no key '" + std::string(name) + "'");
    }
    if (!entry->place.nowhere()) host_.used(entry->place);
    return heap_.wrapped(entry->value);
  }
  if (of.is_number() && (name == "real" || name == "imag")) {
    if (name == "real") return of.is(Type::kBool) ? Value::integer(of.integer_) : of;
    return of.is(Type::kReal) ? Value::real(0) : Value::integer(0);
  }
  return fail(FactKind::kNoSuchItem, std::string(name), no_attribute(of, name));
}

std::optional<std::vector<Value>> Evaluator::items_of(Value iterable) {
  std::vector<Value> items;
  switch (iterable.type) {
    case Type::kList:
    case Type::kTuple: {
      items = iterable.sequence_->items->values;
      if (iterable.sequence_->dotted) {
        for (Value& item : items) item = heap_.wrapped(item);
      }
      break;
    }
    case Type::kDictionary:
    case Type::kSet:
    case Type::kFrozenSet:
      for (const Entry& entry : iterable.dictionary_->entries->list) items.push_back(entry.key);
      break;
    case Type::kText:
      if (!fits(iterable.size)) return std::nullopt;
      for (std::size_t at = 0; at < iterable.size;) {
        const std::size_t begin = at;
        next_code_point(iterable.as_text(), at);
        items.push_back(Value::text(iterable.as_text().substr(begin, at - begin)));
      }
      break;
    case Type::kRange: {
      const std::int64_t size = range_size(*iterable.iterator_);
      if (!fits(static_cast<std::uint64_t>(size))) return std::nullopt;
      for (std::int64_t i = 0; i < size; ++i) {
        items.push_back(Value::integer(iterable.iterator_->values[0].integer_ +
                                       i * iterable.iterator_->values[2].integer_));
      }
      break;
    }
    case Type::kView: items = iterable.iterator_->values; break;
    case Type::kIterator: {
      Iterator& iterator = *iterable.iterator_;
      items.assign(iterator.values.begin() + static_cast<std::ptrdiff_t>(iterator.next),
                   iterator.values.end());
      iterator.next = iterator.values.size();
      break;
    }
    default:
      wrong_type("a " + std::string(type_name(iterable)) + " has no items to go through");
      return std::nullopt;
  }
  if (!work(1 + items.size() / 8)) return std::nullopt;
  return items;
}

Value Evaluator::call_function(const Function& function, Value self, Arguments& arguments) {
  const auto count = static_cast<int>(arguments.values.size());
  const std::string name(function.name);
  for (const auto& [key, value] : arguments.named) {
    const bool known =
        function.names == "*" ||
        (' ' + std::string(function.names) + ' ').find(' ' + std::string(key) + ' ') !=
            std::string::npos;
    if (!known) return wrong_type(name + "() takes no argument named '" + std::string(key) + "'");
  }
  // A named argument may represent one that is due.
  if (count + static_cast<int>(arguments.named.size()) < function.least) {
    return wrong_type(name + "() takes at least " + std::to_string(function.least) +
                      " arguments, not " + std::to_string(count));
  }
  if (function.most != kAnyCount && count > function.most) {
    return wrong_type(name + "() takes at most " + std::to_string(function.most) +
                      " arguments, not " + std::to_string(count));
  }
  return function.call(*this, self, arguments);
}

Value Evaluator::call(Value callee, Arguments& arguments) {
  if (!work(1)) return Value::error();
  if (callee.is(Type::kFunction) || callee.is(Type::kClass)) {
    return call_function(*callee.function_, Value::none(), arguments);
  }
  if (callee.is(Type::kMethod)) {
    Value self = callee.method_->self;
    if (self.failed()) {
      // `str.lower`: the value is the first argument.
      if (arguments.values.empty()) return wrong_type("a method without its value");
      self = arguments.values.front();
      if (method_of(self, callee.method_->function->name) != callee.method_->function) {
        return wrong_type("a method of another type than " + std::string(type_name(self)));
      }
      arguments.values.erase(arguments.values.begin());
    }
    return call_function(*callee.method_->function, self, arguments);
  }
  return wrong_type("a " + std::string(type_name(callee)) + " is no function");
}

Value Evaluator::call(Value callee, std::vector<Value> values) {
  Arguments arguments{std::move(values), {}};
  return call(callee, arguments);
}

}  // namespace rigor::xacro
