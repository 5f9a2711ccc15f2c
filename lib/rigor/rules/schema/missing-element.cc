// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_in_attribute.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::missing_element {

/// A file of colors or constants that xacro files include: no robot is loaded from it alone.
bool is_fragment(xml::Element element) {
  if (element.name() != "robot" || element.children().empty()) return false;
  if (!element.attribute("xmlns:xacro")) return false;
  return !element.child("link") && !element.child("joint");
}

/// What a reader makes of it, by what is missing where.
std::string why_of(std::string_view parent, std::string_view name, const Context& context) {
  if (context.is_urdf() && parent == "robot") {
    return "urdfdom rejects a robot without links, and libsdformat a model without any.";
  }
  if (context.is_urdf() && parent == "joint") {
    return "urdfdom rejects the whole robot: a joint needs a parent and a child.";
  }
  if (context.is_sdf() && parent == "joint") return "libsdformat rejects the whole file.";
  if (context.is_sdf() && name == "uri") {
    return "libsdformat gives the mesh a name that no file has, so it is neither drawn nor felt.";
  }
  return {};
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.node->name());
  if (!is_needed(fact.element.name(), name, context)) return;
  if (fact.element.attribute(name)) return;  // element-as-attribute
  if (has_xacro_child(fact.element) || is_fragment(fact.element)) return;
  const auto misspelt = misspelt_child(fact.element, name, context);
  context.report(
      {.where = fact.where,
       .message = "<" + std::string(fact.element.name()) + "> has no <" + name + ">",
       .subject = subject_of(fact.element),
       .help = misspelt ? "did you mean <" + name + "> by <" + std::string(misspelt->name()) + ">?"
                        : "add <" + name + ">",
       .fix = misspelt ? fix_of("write <" + name + ">", Applicability::kUnsafe,
                                xml::rename_element(context.document(), *misspelt, name))
                       : std::nullopt,
       .refused = fact.element.name() == "robot" || fact.element.name() == "joint",
       .why = why_of(fact.element.name(), name, context)});
}

/// An end that is there and names nothing.
void check_ends(const model::Joint& joint, Context& context) {
  for (const std::string name : {"parent", "child"}) {
    const auto end = context.element(joint.site).child(name);
    if (!context.is_sdf() || !end || !read::trimmed(end->text()).empty()) continue;
    const auto link = end->attribute("link");
    if (!link) {
      context.report({.where = end->tag_span(),
                      .message = "the <" + name + "> of the joint is empty",
                      .subject = context.subject(joint),
                      .refused = true});
    } else if (!read::values_are_attributes(*end)) {
      context.report(
          {.where = end->tag_span(),
           .message = "the <" + name +
                      "> of the joint is empty: after SDF 1.0 no attribute names the link",
           .subject = context.subject(joint),
           .fix = value_as_text(*link, *end, context),
           .refused = true});
    }
  }
}

Rule rule() {
  return {
      .name = "missing-element",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a required element is missing",
      .why = "libsdformat rejects a joint that lacks its parent or child, and gives a mesh without "
             "<uri> a name that no file has. urdfdom rejects the robot, or stops reading the link: "
             "this part and all that follow are not there, first the visuals, then the collisions. "
             "Other required elements of SDF have a default: see defaulted-element.",
      .what_to_do = "Add the element.",
      .checks = {on_schema({read::SchemaFactKind::kMissingElement}, check),
                 on<model::Joint>(check_ends)},
  };
}

}  // namespace rigor::rules::missing_element
