// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/value.h>

namespace rigor::rules::repeated_element {

/// Readers take all of these, whatever the format says: of a multicamera the cameras, of a contact
/// sensor the collisions, of a script its folders, of a polyline its holes.
bool all_are_read(std::string_view name, std::string_view parent) {
  return name == "camera" || name == "polyline" || (name == "collision" && parent == "contact") ||
         (name == "uri" && parent == "script");
}

/// A file may repeat elements that repeat elements: what is longer is taken to differ.
constexpr std::uint32_t kMaxCompared = 1000;

/// The next word of a text, taken off it; empty at the end.
std::string_view take_word(std::string_view& text) {
  text = read::trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(" \t\n\r"));
  text.remove_prefix(word.size());
  return word;
}

/// Word by word, and numbers by what they are worth: 0 0 0 is 0.0 0 -0.
bool same_words(std::string_view a, std::string_view b) {
  while (true) {
    const std::string_view x = take_word(a);
    const std::string_view y = take_word(b);
    if (x.empty() || y.empty()) return x.empty() && y.empty();
    if (x == y) continue;
    const auto left = schema::parse_double(x);
    const auto right = schema::parse_double(y);
    const auto* const p = std::get_if<double>(&left);
    const auto* const q = std::get_if<double>(&right);
    if (p == nullptr || q == nullptr || *p != *q) return false;
  }
}

bool same_start(xml::Element a, xml::Element b) {
  if (a.name() != b.name() || !same_words(a.text(), b.text())) return false;
  std::size_t more = 0;
  for (const xml::Attribute attribute : a.attributes()) {
    const auto other = b.attribute(attribute.name());
    if (!other || !same_words(attribute.value(), other->value())) return false;
    ++more;
  }
  for ([[maybe_unused]] const xml::Attribute attribute : b.attributes()) --more;
  return more == 0;
}

/// Whether two siblings of one name, and all that is in them, say the same.
bool same(xml::Element a, xml::Element b, const xml::Document& document) {
  const auto within = [&document](xml::Element top, std::uint32_t offset) {
    const std::uint32_t index = top.index() + offset;
    return index < document.element_count() &&
           document.element(index).span().begin < top.span().end;
  };
  for (std::uint32_t i = 0; i < kMaxCompared; ++i) {
    const bool more = within(a, i);
    if (more != within(b, i)) return false;
    if (!more) return true;
    const xml::Element x = document.element(a.index() + i);
    const xml::Element y = document.element(b.index() + i);
    if (!same_start(x, y)) return false;
    if (i > 0 && x.parent()->index() - a.index() != y.parent()->index() - b.index()) return false;
  }
  return false;
}

/// What an exporter of old wrote where nothing was set.
bool says_nothing(xml::Element element) { return read::trimmed(element.text()) == "__default__"; }

/// The first of the others that says something, and something else than the first of all.
std::optional<xml::Element> contradiction(xml::Element second, const Context& context) {
  std::optional<xml::Element> first;
  for (const xml::Element sibling : second.parent()->children()) {
    if (sibling.name() != second.name()) continue;
    if (!first) {
      first = sibling;
    } else if (!says_nothing(sibling) && !same(*first, sibling, context.document())) {
      return sibling;
    }
  }
  return std::nullopt;
}

/// Elements that one fix removes: each costs a walk to the start of its line. More are no slip.
constexpr std::size_t kMaxRemoved = 100;

/// One finding represents all of them.
std::vector<Edit> without_others(const read::SchemaFact& fact, const Context& context) {
  std::vector<Edit> edits;
  std::size_t removed = 0;
  for (const xml::Element other : fact.element.parent()->children()) {
    if (other.index() < fact.element.index() || other.name() != fact.element.name()) continue;
    if (++removed > kMaxRemoved) return {};
    append(edits, xml::remove_element(context.document(), other));
  }
  return edits;
}

void check(const read::SchemaFact& fact, Context& context) {
  const std::string name(fact.element.name());
  const auto parent = fact.element.parent();
  if (!parent || all_are_read(name, parent->name())) return;
  if (parent->name() == "sdf") return;  // several-at-top-level
  const auto other = contradiction(fact.element, context);
  if (!other) return;  // every reader gets the same value
  context.report({.where = other->name_span(),
                  .message = "a second <" + name + "> has no effect: the first counts",
                  .subject = subject_of(fact.element),
                  .related = {{fact.related, "the first"}},
                  .fix = fix_of("remove all but the first", Applicability::kUnsafe,
                                without_others(fact, context))});
}

Rule rule() {
  return {
      .name = "repeated-element",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "repeated element where one is allowed",
      .why = "libsdformat, urdfdom and Gazebo read the first and ignore the others silently: the "
             "others have no effect. Identical repetitions are not reported.",
      .what_to_do = "Keep one of them.",
      .checks = {on_schema({read::SchemaFactKind::kRepeatedElement}, check)},
  };
}

}  // namespace rigor::rules::repeated_element
