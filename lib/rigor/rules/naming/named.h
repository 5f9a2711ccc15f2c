// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of the things of a scope have the name of another, and what they are called.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include <rigor/rules/names.h>

namespace rigor::rules {

/// "arm/link palm/collision pad": the names on the way in from the root.
inline std::string subject_of(const Named& named) {
  std::string subject;
  for (std::optional<xml::Element> at = named.element; at; at = at->parent()) {
    const auto name = at->attribute("name");
    const bool itself = *at == named.element;
    if (!name && !itself) continue;
    const std::string_view called = itself ? named.name : name->value();
    const bool model = at->name() == "model" || at->name() == "robot" || at->name() == "include";
    std::string part = model ? "" : std::string(at->name()) + " ";
    part += called;
    subject = subject.empty() ? part : part + "/" + subject;
  }
  return subject;
}

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
