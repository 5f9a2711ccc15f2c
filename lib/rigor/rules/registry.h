// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// All rules, found by name. Made once, by whoever builds the `Environment`; never changes.
//
//   Registry registry;
//   if (const Rule* rule = registry.find("axis-zero")) print(rule->summary);

#pragma once

#include <string_view>
#include <vector>

#include <rigor/rules/rule.h>

namespace rigor::rules {

class Registry {
 public:
  /// Every rule that the library was built with, sorted by name.
  Registry();

  const std::vector<Rule>& rules() const { return rules_; }
  /// By its name, or one that it had before.
  const Rule* find(std::string_view name) const;

 private:
  std::vector<Rule> rules_;
};

/// Rules that have been renamed: configuration, options, suppression comments and baselines may still have the
/// former names. The name that a rule has now; any other name as it is.
std::string_view current_name(std::string_view name);

/// In alphabetical order.
std::vector<std::string_view> former_names();

}  // namespace rigor::rules
