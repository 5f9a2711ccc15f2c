// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean", as a line of help and a fix.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <rigor/rules/context.h>
#include <rigor/schema/suggest.h>
#include <rigor/text/edit.h>

namespace rigor::rules {

/// What a name was probably meant to be; empty when nothing is near.
struct Suggestion {
  std::string help;  ///< "did you mean 'tip'?"
  std::optional<Fix>
      fix;  ///< only where one candidate is near, and the name stands there as it is read
};

/// The nearest of the candidates for the name that stands at `where`. What refers to another thing is
/// another robot: whoever wrote the name has to agree.
inline Suggestion suggest(std::string_view name, const std::vector<std::string>& candidates,
                          Span where, const Context& context) {
  const auto near = schema::near(name, {candidates.begin(), candidates.end()});
  if (near.empty()) return {};
  const std::string meant(near.front());
  Suggestion suggestion{"did you mean '" + meant + "'?", {}};
  const bool plain = meant.find_first_of("<>&\"'") == std::string::npos;
  if (near.size() == 1 && plain && context.bytes(where) == name) {
    suggestion.fix = Fix{"name '" + meant + "'", Applicability::kUnsafe, {{where, meant}}};
  }
  return suggestion;
}

/// The same of what `candidates()` gives, as long as the file is worth the effort.
template <class Candidates>
Suggestion suggest_of(std::string_view name, const Candidates& candidates, Span where,
                      Context& context) {
  if (!context.may_suggest()) return {};
  const std::vector<std::string> names = candidates();
  context.compared(names.size());
  return suggest(name, names, where, context);
}

/// The names of links, joints or whatever else has one.
template <class Entities>
std::vector<std::string> names_of(const Entities& entities) {
  std::vector<std::string> names;
  for (const auto& entity : entities) names.push_back(entity.name.value);
  return names;
}

/// The same, to look up in: views into the entities' own strings.
template <class Entities>
std::unordered_set<std::string_view> name_set(const Entities& entities) {
  std::unordered_set<std::string_view> names;
  for (const auto& entity : entities) names.insert(entity.name.value);
  return names;
}

}  // namespace rigor::rules
