// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/value.h>

namespace rigor::rules::text_between_elements {

/// `<mass>3</mass>` in URDF: missing-attribute says what is wrong.
bool meant_as_attribute(const read::SchemaFact& fact, const Context& context) {
  if (!context.is_urdf() || !fact.element.children().empty()) return false;
  for (const schema::Node required : fact.node->required_attributes()) {
    if (!fact.element.attribute(required.name())) return true;
  }
  return false;
}

/// What may be a value is not thrown away.
bool begins_with_number(std::string_view text) {
  const std::size_t at = text.find_first_not_of("+-.");
  return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

bool has_several_numbers(schema::Type type) {
  using schema::Type;
  return type == Type::kVector2 || type == Type::kVector2i || type == Type::kVector3 ||
         type == Type::kPose || type == Type::kQuaternion;
}

/// The child that the numbers were meant for: `<axis>0 1 0</axis>` is its xyz. The only one of several
/// numbers that takes them, or else the only one that has to be there.
std::optional<schema::Node> meant_child(const read::SchemaFact& fact, std::string_view numbers) {
  if (fact.node->type() != schema::Type::kNone) return std::nullopt;
  std::vector<schema::Node> several;
  std::vector<schema::Node> required;
  for (const schema::Node child : fact.node->children()) {
    const bool one = child.type() == schema::Type::kDouble || child.type() == schema::Type::kFloat;
    if (!one && !has_several_numbers(child.type())) continue;
    if (fact.has_child(child.name()) || schema::check(child.type(), numbers)) continue;
    if (!one) several.push_back(child);
    if (child.cardinality() == schema::Cardinality::kOne) required.push_back(child);
  }
  if (several.size() == 1) return several.front();
  return required.size() == 1 ? std::optional(required.front()) : std::nullopt;
}

/// What is to be looked for: in a template the place may be that of a call.
std::string in_short(std::string_view text) {
  constexpr std::size_t kMax = 30;
  std::string line(text.substr(0, text.find('\n')));
  if (line.size() > kMax) {
    std::size_t end = kMax;
    // Whole code points, where it has any.
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
    line.resize(end);
  }
  return '\'' + line + (line.size() < text.size() ? "…'" : "'");
}

Span trimmed_span(const read::SchemaFact& fact, const Context& context) {
  const std::string_view all = context.bytes(fact.where);
  const std::string_view inner = read::trimmed(all);
  Span span = fact.where;
  span.begin += static_cast<std::uint32_t>(inner.data() - all.data());
  span.end = span.begin + static_cast<std::uint32_t>(inner.size());
  return span;
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view text = read::trimmed(context.bytes(fact.where));
  if (meant_as_attribute(fact, context) || has_xacro(text)) return;
  if (fact.element.name() == "script") return;  // material-script-incomplete
  const std::string parent = "<" + std::string(fact.element.name()) + ">";
  Finding finding{.where = fact.where,
                  .message = "text " + in_short(text) + " in " + parent + " has no effect",
                  .subject = subject_of(fact.element)};
  if (const auto child = meant_child(fact, text)) {
    const std::string name(child->name());
    const std::string element = "<" + name + ">" + std::string(text) + "</" + name + ">";
    finding.message += ": the value of <" + name + "> is meant";
    finding.help = "write " + element;
    finding.fix =
        Fix{"write " + element, Applicability::kUnsafe, {{trimmed_span(fact, context), element}}};
  } else if (!begins_with_number(text)) {
    finding.fix = Fix{"remove it", Applicability::kUnsafe, {without(context, fact.where)}};
  }
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "text-between-elements",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "stray text between elements",
      .why = "libsdformat, urdfdom and Gazebo read the first run of text of an element that has a "
             "value, and no text of one that has none: the rest has no effect. A comment inside a "
             "number splits it, and the first part is read.",
      .what_to_do = "Remove the characters, or make them a comment. Numbers go into the element "
                    "that is meant.",
      .checks = {on_schema({read::SchemaFactKind::kLostText}, check)},
  };
}

}  // namespace rigor::rules::text_between_elements
