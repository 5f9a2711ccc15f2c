// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <rigor/rules/registry.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {

std::optional<std::string> unknown_name(const Selection& selection, const Registry& registry) {
  if (selection.select.empty() && selection.ignore.empty() && selection.severity.empty())
    return std::nullopt;
  std::set<std::string_view> known;
  for (const Rule& rule : registry.rules()) {
    known.insert(rule.name);
    known.insert(to_string(rule.category));
  }
  for (const auto* list : {&selection.select, &selection.ignore}) {
    for (const std::string& name : *list) {
      if (!known.contains(name)) return name;
    }
  }
  for (const auto& [name, level] : selection.severity) {
    if (!known.contains(name)) return name;
  }
  return std::nullopt;
}

}  // namespace rigor::rules
