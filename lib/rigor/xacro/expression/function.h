// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions of the expression language: tables of a name and what it does, by module and by the type
// they are methods of.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/xacro/value/value.h>

namespace rigor::xacro {

class Evaluator;

struct Arguments {
  std::vector<Value> values;
  std::vector<std::pair<std::string_view, Value>> named;

  bool has(std::size_t i) const { return i < values.size(); }
  Value get(std::size_t i, Value otherwise = {}) const { return has(i) ? values[i] : otherwise; }
  std::optional<Value> find(std::string_view name) const {
    for (const auto& [key, value] : named) {
      if (key == name) return value;
    }
    return std::nullopt;
  }
};

inline constexpr int kAnyCount = -1;
inline constexpr std::string_view kNoNames{};

struct Function {
  std::string_view name;
  Value (*call)(Evaluator& evaluator, Value self, Arguments& arguments);
  int least = 0;
  int most = 0;  ///< arguments without a name; kAnyCount is no limit
  /// Names of arguments, separated by blanks; "*" takes all. Those before a `/` are not also positions.
  std::string_view names = kNoNames;
};

struct Constant {
  std::string_view name;
  double value;
};

struct Module {
  std::string_view name;
  std::span<const Function> classes;
  std::span<const Function> functions;
  std::span<const Constant> constants;
};

std::optional<Value> member_of(const Module& module, std::string_view name);

extern const Module kPythonModule;
extern const Module kMathModule;
extern const Module kXacroModule;

/// A class of the python module, such as "list".
const Function& class_named(std::string_view name);

/// What a value has behind a dot; null when it has no such method.
const Function* method_of(Value self, std::string_view name);
const Function* text_method(std::string_view name);
const Function* list_method(std::string_view name);
const Function* tuple_method(std::string_view name);
const Function* dictionary_method(std::string_view name);
const Function* set_method(std::string_view name);
const Function* number_method(std::string_view name);

/// Number of items of a range, by its start, stop and step.
std::int64_t range_size(const Iterator& range);

const Function* function_named(std::span<const Function> functions, std::string_view name);

}  // namespace rigor::xacro
