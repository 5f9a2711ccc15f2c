// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the reference has without a module's name before it.

#include <rigor/xacro/builtins.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include <rigor/xacro/expression/function.h>

namespace rigor::xacro {
namespace {

constexpr std::string_view kGlobalFunctions[] = {"list",  "dict",   "map",  "len", "str",
                                                 "float", "int",    "bool", "min", "max",
                                                 "round", "sorted", "range"};
constexpr std::string_view kGlobalXacroFunctions[] = {"load_yaml", "abs_filename", "dotify"};

constexpr std::array<const Module*, 3> kGlobalModules{&kPythonModule, &kMathModule, &kXacroModule};

bool is_among(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::optional<Value> global_builtin(std::string_view name) {
  if (const auto member = member_of(kMathModule, name)) return member;
  if (is_among(name, kGlobalXacroFunctions)) return member_of(kXacroModule, name);
  if (is_among(name, kGlobalFunctions)) return member_of(kPythonModule, name);
  const auto* const module = std::find_if(kGlobalModules.begin(), kGlobalModules.end(),
                                          [name](const Module* m) { return m->name == name; });
  if (module == kGlobalModules.end()) return std::nullopt;
  return Value::module(**module);
}

std::vector<std::string_view> global_builtin_names() {
  std::vector<std::string_view> names(std::begin(kGlobalFunctions), std::end(kGlobalFunctions));
  names.insert(names.end(), std::begin(kGlobalXacroFunctions), std::end(kGlobalXacroFunctions));
  for (const Module* module : kGlobalModules) names.push_back(module->name);
  for (const Function& function : kMathModule.functions) names.push_back(function.name);
  for (const Constant& constant : kMathModule.constants) names.push_back(constant.name);
  return names;
}

}  // namespace rigor::xacro
