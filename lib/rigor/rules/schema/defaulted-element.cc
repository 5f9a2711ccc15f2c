// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::defaulted_element {

/// Where a silent default surprises: shapes and sensors. What a world, its scene, engine, lights
/// and materials leave out is nearly always left out on purpose.
constexpr std::array<std::string_view, 15> kParents = {
    "box",    "sphere", "cylinder", "capsule", "cone",  "ellipsoid",  "plane",   "polyline",
    "camera", "image",  "clip",     "scan",    "range", "horizontal", "vertical"};

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view parent = fact.element.name();
  const auto value = fact.node->default_value();
  if (std::find(kParents.begin(), kParents.end(), parent) == kParents.end() || !value) return;
  if (fact.element.attribute(fact.node->name())) return;                 // element-as-attribute
  if (!read::trimmed(fact.element.text()).empty()) return;               // text-between-elements
  if (misspelt_child(fact.element, fact.node->name(), context)) return;  // unknown-element
  std::string message = "no <" + std::string(fact.node->name()) + "> in <" + std::string(parent) +
                        ">: it is " + std::string(*value);
  if (!fact.node->unit().empty()) message += " " + std::string(fact.node->unit());
  context.report(
      {.where = fact.where, .message = std::move(message), .subject = subject_of(fact.element)});
}

Rule rule() {
  return {
      .name = "defaulted-element",
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a required element is missing, and its default counts",
      .why = "The format asks for the element; libsdformat puts in its default without a word. For "
             "a shape's size or a sensor's picture that is rarely what was meant.",
      .what_to_do = "Write the element, if only to say that the default is meant.",
      .checks = {on_schema({read::SchemaFactKind::kMissingElement}, check)},
  };
}

}  // namespace rigor::rules::defaulted_element
