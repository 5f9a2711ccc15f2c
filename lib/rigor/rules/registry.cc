// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/registry.h>

#include <algorithm>
#include <array>

#include <rigor/rules/registered.h>

namespace rigor::rules {

std::string_view to_string(Category category) {
  constexpr std::array<std::string_view, 18> kNames{
      "xml",        "schema",   "naming",  "reference", "frame",       "inertia",
      "kinematics", "geometry", "mesh",    "physics",   "world",       "plugin",
      "sensor",     "package",  "convert", "simulate",  "suppression", "xacro"};
  static_assert(kNames.size() == static_cast<std::size_t>(Category::kXacro) + 1);
  return kNames[static_cast<std::size_t>(category)];
}

Registry::Registry() : rules_(registered_rules()) {
  std::sort(rules_.begin(), rules_.end(),
            [](const Rule& a, const Rule& b) { return a.name < b.name; });
}

const Rule* Registry::find(std::string_view name) const {
  const auto found = std::lower_bound(
      rules_.begin(), rules_.end(), name,
      [](const Rule& rule, std::string_view wanted) { return rule.name < wanted; });
  return found != rules_.end() && found->name == name ? &*found : nullptr;
}

}  // namespace rigor::rules
