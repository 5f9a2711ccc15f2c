// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/schema/refused_value.h>

namespace rigor::rules::misplaced_element {

constexpr std::size_t kMaxPlaces = 3;  // a longer list is not read

std::string list(const std::vector<std::string>& places) {
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), kMaxPlaces); ++i) {
    text += (i > 0 ? ", <" : "<") + places[i].substr(places[i].rfind('/') + 1) + ">";
  }
  return places.size() > kMaxPlaces ? text + " and others" : text;
}

/// The nearest element around it that takes it is what was meant.
std::string help_of(const read::SchemaFact& fact, const std::vector<std::string>& places,
                    const Context& context) {
  if (fact.is_inside("state")) {
    return "write it in the <model> itself: a <state> has only what changes in time";
  }
  const schema::Version version = fact.parent->version();
  for (auto around = fact.element.parent(); around; around = around->parent()) {
    const auto outer = node_in(version, *around, *context.schema());
    if (outer && outer->child(fact.element.name())) {
      return "move it to the <" + std::string(around->name()) + "> around it";
    }
  }
  return "it belongs in " + list(places);
}

void check(const read::SchemaFact& fact, Context& context) {
  const schema::Version version = fact.parent->version();
  const std::string name(fact.element.name());
  const auto places = context.schema()->parents_of(name, version);
  if (places.empty()) return;                                     // unknown-element
  if (dialect_reader(fact, context)) return;                      // consumer-specific-name
  if (name == "include" && fact.parent->name() == "sdf") return;  // libsdformat resolves it
  // The models, links and lights of a world's <state> have the names of others, and hold less.
  context.report({.where = fact.where,
                  .message = "<" + name + "> has no effect in <" +
                             std::string(fact.parent->name()) +
                             (fact.is_inside("state") ? "> of a <state>" : ">"),
                  .subject = subject_of(fact.element),
                  .help = help_of(fact, places, context)});
}

Rule rule() {
  return {
      .name = "misplaced-element",
      .severity = Severity::kWarning,
      .summary = "an element is in a place where the format does not have it",
      .why = "libsdformat and Gazebo look for it in another element and ignore it here; only newer "
             "libsdformat warns. urdfdom ignores it silently.",
      .what_to_do = "Move it to the element that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kUnknownElement}, check)},
  };
}

}  // namespace rigor::rules::misplaced_element
