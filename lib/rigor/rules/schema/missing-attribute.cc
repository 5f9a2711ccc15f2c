// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/schema/value.h>
#include <rigor/xml/edit.h>

namespace rigor::rules::missing_attribute {

/// What stands there in its place: another spelling, or a child element.
std::string instead(const read::SchemaFact& fact, std::string_view name) {
  for (const xml::Attribute attribute : fact.element.attributes()) {
    if (fact.parent->attribute(attribute.name())) continue;
    if (schema::near(attribute.name(), {name}).empty()) continue;
    return "did you mean '" + std::string(name) + "' by '" + std::string(attribute.name()) + "'?";
  }
  if (!fact.has_child(name)) return {};
  return "<" + std::string(name) + "> is written as a child: it is an attribute";
}

std::optional<Fix> respelt(const read::SchemaFact& fact, std::string_view name) {
  for (const xml::Attribute attribute : fact.element.attributes()) {
    if (fact.parent->attribute(attribute.name())) continue;
    if (schema::near(attribute.name(), {name}).empty()) continue;
    return Fix{"write '" + std::string(name) + "'",
               Applicability::kUnsafe,
               {{attribute.name_span(), std::string(name)}}};
  }
  return std::nullopt;
}

bool looks_at_axis(const read::SchemaFact& fact) {
  const auto type = fact.element.parent()->attribute("type");
  return !type || (type->value() != "fixed" && type->value() != "floating");
}

/// urdfdom takes the default where there is one (but of an axis).
bool needed(const read::SchemaFact& fact, const schema::Node& attribute, const Context& context) {
  const std::string_view name = fact.element.name();
  if (name == "sdf" || name == "gazebo")
    return attribute.name() != "version";  // sdf-version-missing
  if (!context.is_urdf()) return true;
  if (name == "axis") return attribute.name() == "xyz" && looks_at_axis(fact);
  return !attribute.default_value() && !may_lack_attributes(name, context);
}

/// All that the element lacks, each in quotes.
std::string missing(const read::SchemaFact& fact, const Context& context) {
  std::string names;
  for (const schema::Node attribute : fact.parent->required_attributes()) {
    if (fact.element.attribute(attribute.name())) continue;
    if (!needed(fact, attribute, context)) continue;
    names += (names.empty() ? "'" : ", '") + std::string(attribute.name()) + "'";
  }
  return names;
}

/// urdfdom gives up a robot without a name for itself, for a link or in a joint.
bool urdf_refused(const read::SchemaFact& fact) {
  const std::string_view element = fact.element.name();
  return element == "robot" || element == "link" || urdfdom_refuses_in(fact.element);
}

/// ` link="a"`; nothing where the text is no value of the attribute.
std::optional<std::string> as_attribute(const schema::Node& attribute, std::string_view text) {
  const std::string_view value = read::trimmed(text);
  if (value.empty() || schema::check(attribute.type(), value)) return std::nullopt;
  return " " + std::string(attribute.name()) + "=\"" + xml::escaped(value) + "\"";
}

/// `<parent>a</parent>`, `<axis><xyz>0 0 1</xyz></axis>`: the element with its values as attributes, as URDF has it.
/// Nothing when some of what it holds would be lost, or it lacks a value all the same.
std::optional<std::string> with_attributes(const read::SchemaFact& fact) {
  const xml::Element element = fact.element;
  if (!element.attributes().empty()) return std::nullopt;
  std::string attributes;
  for (const xml::Element child : element.children()) {
    const auto attribute = fact.parent->attribute(child.name());
    const bool plain = child.attributes().empty() && child.children().empty();
    const auto text = attribute && plain ? as_attribute(*attribute, child.text()) : std::nullopt;
    if (!text || element.child(child.name())->index() != child.index()) return std::nullopt;
    attributes += *text;
  }
  std::size_t required = 0;
  for (const schema::Node attribute : fact.parent->required_attributes()) {
    ++required;
    if (element.child(attribute.name())) continue;
    const auto text = as_attribute(attribute, element.text());
    if (!element.children().empty() || required > 1 || !text) return std::nullopt;
    attributes += *text;
  }
  return "<" + std::string(element.name()) + attributes + "/>";
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view name = fact.node->name();
  if (!needed(fact, *fact.node, context)) return;
  const std::string names = missing(fact, context);
  if (!names.starts_with("'" + std::string(name) + "'")) return;  // reported at the first of them
  const auto as_in_urdf = context.is_urdf() ? with_attributes(fact) : std::nullopt;
  if (as_in_urdf) {
    context.report(
        {.where = fact.where,
         .message = "<" + std::string(fact.element.name()) + "> has no " + names +
                    ": this is SDF's form; URDF writes " + *as_in_urdf,
         .subject = subject_of(fact.element),
         .fix = fix_of("write it as URDF has it", Applicability::kUnsafe,
                       xml::replace_element(context.document(), fact.element, *as_in_urdf)),
         .refused = urdf_refused(fact),
         .cause = "SDF's form of " + std::string(fact.element.name())});
    return;
  }
  context.report({.where = fact.where,
                  .message = "<" + std::string(fact.element.name()) + "> has no " + names,
                  .subject = subject_of(fact.element),
                  .help = instead(fact, name),
                  .fix = respelt(fact, name),
                  .refused = urdf_refused(fact)});
}

Rule rule() {
  return {
      .name = "missing-attribute",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kSays},
      .fix = FixGrade::kUnsafe,
      .summary = "a required attribute is missing",
      .why = "libsdformat rejects the file at this element. urdfdom rejects the robot, or stops "
             "reading the link: this part and all that follow are not there. The joint of an "
             "<axis> without xyz has the axis 0 0 0.",
      .what_to_do = "Add the attribute. What SDF writes between tags, <parent>a</parent>, is an "
                    "attribute in URDF: <parent link=\"a\"/>.",
      .checks = {on_schema({read::SchemaFactKind::kMissingAttribute}, check)},
  };
}

}  // namespace rigor::rules::missing_attribute
