// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/schema/value_in_attribute.h>

namespace rigor::rules::unknown_attribute {

constexpr std::uint32_t kNearby = 100;  // elements: the next joint is some 20 further on

/// Whether an element near by has the attribute, too: then it is no slip of the pen. URDF readers
/// ignore what they do not know, and laboratories add what their own tools read (`mu_viscous` of the
/// dynamics of each joint).
bool is_habit(const read::SchemaFact& fact, const xml::Document& document) {
  const std::uint32_t here = fact.element.index();
  const std::uint32_t end = std::min(document.element_count(), here + kNearby);
  for (std::uint32_t i = here - std::min(here, kNearby); i < end; ++i) {
    const xml::Element other = document.element(i);
    if (i != here && other.name() == fact.element.name() &&
        other.attribute(fact.attribute->name())) {
      return true;
    }
  }
  return false;
}

/// Whether the value is one that the attribute of the other name can have.
bool fits(std::string_view value, const read::SchemaFact& fact, std::string_view meant) {
  const auto attribute = fact.parent->attribute(meant);
  return attribute && !schema::check(attribute->type(), value);
}

/// What urdfdom says, where it looks for the value.
std::string why_of(const read::SchemaFact& fact, std::string_view meant, const Context& context) {
  if (!context.is_urdf() || fact.element.name() != "color" || meant != "rgba") return {};
  const auto material = fact.element.parent();
  const auto name = material ? material->attribute("name") : std::nullopt;
  return "check_urdf prints \"Material [" + std::string(name ? name->value() : "") +
         "] color has no rgba\", and the material has no color.";
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string_view name = fact.attribute->name();
  const bool reported = !may_lack_attributes(fact.element.name(), context);
  if (reported && meant_for_missing(fact, name)) return;
  if (dialect_reader(fact, context)) return;  // consumer-specific-name
  const auto near = schema::near(name, node_names(fact.parent->attributes()));
  if (context.is_urdf() && near.empty() && is_habit(fact, context.document())) return;
  std::optional<Fix> fix;
  if (holds_value(*fact.attribute, fact.element, *fact.parent)) {
    fix = value_as_text(*fact.attribute, fact.element, context);
  } else if (near.size() == 1 && !fact.element.attribute(near.front()) &&
             fits(fact.attribute->value(), fact, near.front())) {
    const std::string meant(near.front());
    fix = Fix{"write '" + meant + "'", Applicability::kUnsafe, {{fact.where, meant}}};
  }
  context.report({.where = fact.where,
                  .message = "'" + std::string(name) + "' is not an attribute of <" +
                             std::string(fact.element.name()) + ">: it has no effect",
                  .subject = subject_of(fact.element),
                  .help = near.empty() ? "" : "did you mean '" + std::string(near.front()) + "'?",
                  .fix = std::move(fix),
                  .why = near.empty() ? "" : why_of(fact, near.front(), context)});
}

Rule rule() {
  return {
      .name = "unknown-attribute",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "unknown attribute",
      .why =
          "libsdformat warns, urdfdom and Gazebo ignore it silently: it has no effect. Attributes "
          "that another known consumer reads are reported by consumer-specific-name.",
      .what_to_do = "Write the name that was meant. Attributes of your own take a prefix, as in "
                    "mine:note=\"…\", and are not reported; neither are those that several joints "
                    "or links of a URDF share.",
      .checks = {on_schema({read::SchemaFactKind::kUnknownAttribute}, check)},
  };
}

}  // namespace rigor::rules::unknown_attribute
