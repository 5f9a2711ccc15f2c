// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean", as a line of help.

#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <rigor/rules/context.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules {

/// "did you mean 'tip'?", with the nearest of the candidates; empty when none is near.
inline std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const auto near = schema::near(name, {candidates.begin(), candidates.end()});
  return near.empty() ? std::string() : "did you mean '" + std::string(near.front()) + "'?";
}

/// The same of what `candidates()` gives, as long as the file is worth the effort.
template <class Candidates>
std::string did_you_mean(std::string_view name, const Candidates& candidates, Context& context) {
  if (!context.may_suggest()) return {};
  const std::vector<std::string> names = candidates();
  context.compared(names.size());
  return did_you_mean(name, names);
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
