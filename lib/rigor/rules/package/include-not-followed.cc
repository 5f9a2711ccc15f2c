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
  if (fact.name.starts_with("model://")) {
    return context.report(
        {.where = fact.where,
         .message = "'" + fact.name + "' is not installed here, and was not checked",
         .help = "To have it checked, give the folder that it is in with --model-path DIR",
         .why =
             "Gazebo classic has the model installed, or downloads it from its public database. gz "
             "sim does neither: there the folder must be in GZ_SIM_RESOURCE_PATH."});
  }
  context.report({.where = fact.where,
                  .message = "'" + fact.name + "' is not in the Fuel cache, and was not checked"});
}

Rule rule() {
  return {
      .name = "include-not-followed",
      .severity = Severity::kInfo,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "an included model is on the network and was not checked",
      .why =
          "Nothing is ever downloaded here: a model of an https:// URI is only read when it is "
          "in the Fuel cache, and one of Gazebo classic's public database (model://sun), in files "
          "up to SDF 1.7, where it is installed. What refers to its parts cannot be checked.",
      .what_to_do = "Download it once, as with gz fuel download -u URI, and it will be found in "
                    "the cache; or "
                    "give the folder of the database's models with --model-path.",
      .checks = {on_read({read::FactKind::kUnfollowedInclude}, check)},
  };
}

}  // namespace rigor::rules::include_not_followed
