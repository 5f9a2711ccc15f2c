// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/ordering.h>

#include <algorithm>
#include <utility>

#include <rigor/xacro/value/compare.h>

namespace rigor::xacro {

std::optional<std::vector<Value>> keys_of(Evaluator& evaluator, const std::vector<Value>& items,
                                          Value key) {
  if (key.is(Type::kNone)) return items;
  std::vector<Value> keys;
  keys.reserve(items.size());
  for (const Value item : items) {
    keys.push_back(evaluator.call(key, {item}));
    if (keys.back().failed()) return std::nullopt;
  }
  return keys;
}

bool sort_values(Evaluator& evaluator, std::vector<Value>& items, const Arguments& arguments) {
  const auto keys = keys_of(evaluator, items, arguments.find("key").value_or(Value::none()));
  if (!keys || !evaluator.work(items.size() * 4)) return false;
  const bool reverse = is_true(arguments.find("reverse").value_or(Value::boolean(false)));
  std::vector<std::pair<Value, Value>> rows;
  rows.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) rows.emplace_back((*keys)[i], items[i]);
  // A merge sort of our own, since std::sort needs an order that is one, which NaNs and failures are not.
  std::vector<std::pair<Value, Value>> other(rows.size());
  for (std::size_t width = 1; width < rows.size(); width *= 2) {
    for (std::size_t low = 0; low < rows.size(); low += 2 * width) {
      const std::size_t middle = std::min(low + width, rows.size());
      const std::size_t high = std::min(low + 2 * width, rows.size());
      std::size_t left = low;
      std::size_t right = middle;
      for (std::size_t to = low; to < high; ++to) {
        bool take_right = left == middle;
        if (!take_right && right < high) {
          const Value less =
              reverse ? evaluator.compare(Operation::kLess, rows[left].first, rows[right].first)
                      : evaluator.compare(Operation::kLess, rows[right].first, rows[left].first);
          if (less.failed()) return false;
          take_right = is_true(less);
        }
        other[to] = rows[take_right ? right++ : left++];
      }
    }
    rows.swap(other);
  }
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = rows[i].second;
  return true;
}

}  // namespace rigor::xacro
