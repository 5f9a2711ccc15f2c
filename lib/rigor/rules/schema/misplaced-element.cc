// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::misplaced_element {

constexpr std::size_t kMostPlaces = 3;  // a longer list is read by nobody

std::string list(const std::vector<std::string>& places) {
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), kMostPlaces); ++i) {
    text += (i > 0 ? ", <" : "<") + places[i].substr(places[i].rfind('/') + 1) + ">";
  }
  return places.size() > kMostPlaces ? text + " and others" : text;
}

void check(const read::SchemaFact& fact, Context& context) {
  const schema::Version version = fact.parent->version();
  const std::string name(fact.element.name());
  const auto places = context.schema()->parents_of(name, version);
  if (places.empty()) return;  // unknown-element
  // The models, links and lights of a world's <state> have the names of others, and hold less.
  context.report({.where = fact.where,
                  .message = "<" + name + "> has no effect in <" +
                             std::string(fact.parent->name()) +
                             (fact.is_inside("state") ? "> of a <state>" : ">"),
                  .subject = subject_of(fact.element),
                  .help = "it belongs in " + list(places)});
}

Rule rule() {
  return {
      .name = "misplaced-element",
      .severity = Severity::kWarning,
      .summary = "an element stands where the format does not look for it",
      .why =
          "libsdformat, urdfdom and Gazebo look for it somewhere else and pass over it here, newer "
          "libsdformat with a warning, the others without a word: what it says has no effect.",
      .what_to_do = "Move it to the element that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kUnknownElement}, check)},
  };
}

}  // namespace rigor::rules::misplaced_element
