// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_not_followed {

constexpr std::size_t kSearched = 300;  // of a file's first includes; real worlds have a hundred

/// Worlds include one buoy fifty times: that it was not examined is reported once.
bool is_reported(const read::Fact& fact, const model::Root& root) {
  for (std::size_t i = 0; i < std::min(root.includes.size(), kSearched); ++i) {
    const model::Include& include = root.includes[i];
    if (!root.own(include.site) || include.uri.span.begin >= fact.where.begin) continue;
    if (include.uri.value == fact.name) return true;
  }
  return false;
}

void check(const read::Fact& fact, Context& context) {
  if (is_reported(fact, context.root())) return;
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is not in the Fuel cache, and was not checked"});
}

Rule rule() {
  return {
      .name = "include-not-followed",
      .severity = Severity::kInfo,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included model is on the network and was not checked",
      .why = "Nothing is ever downloaded here: a model of an https:// URI is only read when it is "
             "in the Fuel cache. What refers to its parts cannot be checked.",
      .what_to_do =
          "Download it once, as with gz fuel download -u URI, and it will be found in the cache.",
      .checks = {on_read({read::FactKind::kUnfollowedInclude}, check)},
  };
}

}  // namespace rigor::rules::include_not_followed
