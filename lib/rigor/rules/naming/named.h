// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of the things of a scope have the name of another, and what they are called.

#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include <rigor/rules/names.h>

namespace rigor::rules {

enum class Kinds { kSame, kDifferent };

/// Calls `tell(first, again)` for every member whose name an earlier one of its kind, or of a
/// different kind, has.
template <class Tell>
void for_each_repetition(const NameScope& scope, Kinds kinds, Tell tell) {
  std::unordered_map<std::string, const Named*> seen;
  for (const Named& named : scope.members) {
    if (named.name.empty()) continue;
    std::string key(named.name);
    if (kinds == Kinds::kSame) key = std::string(named.kind) + " " + key;
    const auto [first, is_new] = seen.emplace(key, &named);
    if (is_new) continue;
    if (kinds == Kinds::kDifferent && first->second->kind == named.kind) continue;
    tell(*first->second, named);
  }
}

}  // namespace rigor::rules
