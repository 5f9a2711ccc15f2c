// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>

namespace rigor::rules::repeated_element {
namespace {

/// Readers take all of these, whatever the format says: of a multicamera the cameras, of a contact
/// sensor the collisions, of a script its folders, of a polyline its holes.
bool all_are_read(std::string_view name, std::string_view parent) {
  return name == "camera" || name == "polyline" || (name == "collision" && parent == "contact") ||
         (name == "uri" && parent == "script");
}

/// One finding stands for all of them.
std::vector<Edit> without_others(const read::SchemaFact& fact, const Context& context) {
  std::vector<Edit> edits;
  for (const xml::Element other : fact.element.parent()->children()) {
    if (other.index() < fact.element.index() || other.name() != fact.element.name()) continue;
    append(edits, xml::remove_element(context.document(), other));
  }
  return edits;
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.element.name());
  const auto parent = fact.element.parent();
  if (!parent || all_are_read(name, parent->name())) return;
  if (parent->name() == "sdf") return;  // several-at-top-level
  context.report({.where = fact.where,
                  .message = "a second <" + name + "> has no effect: the first counts",
                  .subject = subject_of(fact.element),
                  .related = {{fact.related, "the first"}},
                  .fix = fix_of("remove all but the first", Applicability::kUnsafe,
                                without_others(fact, context))});
}

}  // namespace

Rule rule() {
  return {
      .name = "repeated-element",
      .category = Category::kSchema,
      .severity = Severity::kError,
      .fix = FixGrade::kUnsafe,
      .summary = "an element stands twice where one can be read",
      .why =
          "libsdformat, urdfdom and Gazebo read the first and pass over the others without a "
          "word: half of what the file says has no effect.",
      .what_to_do = "Keep one of them.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <pose>0 0 1 0 0 0</pose>
    <«pose»>0 0 2 0 0 0</pose>
    <link name="body"/>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <pose>0 0 1 0 0 0</pose>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <pose>0 0 1 0 0 0</pose>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kRepeatedElement}, check)},
  };
}

}  // namespace rigor::rules::repeated_element
