// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/conformance.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/values.h>
#include <rigor/text/letter_case.h>

namespace rigor::read {

std::string_view SchemaFact::ancestor(std::size_t levels) const {
  std::optional<xml::Element> at = element;
  for (; at && levels > 0; --levels) at = at->parent();
  return at ? at->name() : std::string_view();
}

bool SchemaFact::is_inside(std::string_view name) const {
  for (auto at = element.parent(); at; at = at->parent()) {
    if (at->name() == name) return true;
  }
  return false;
}

bool SchemaFact::has_child(std::string_view name) const { return element.child(name).has_value(); }

bool SchemaFact::has_sibling(std::string_view name) const {
  const auto above = element.parent();
  return above && above->child(name);
}

namespace {

using schema::Cardinality;
using schema::Node;
using schema::Type;
using Kind = SchemaFactKind;

bool is_foreign(std::string_view name) { return name.find(':') != std::string_view::npos; }

bool is_number(Type type) {
  return type == Type::kDouble || type == Type::kFloat || type == Type::kInt || type == Type::kUint;
}

/// What depends on a sibling's or attribute's value rather than on the place alone.
schema::RotationFormat rotation_format(xml::Element element) {
  const auto format = element.attribute("rotation_format");
  return format && trimmed(format->value()) == "quat_xyzw" ? schema::RotationFormat::kQuatXyzw
                                                           : schema::RotationFormat::kEulerRpy;
}

class SchemaWalk {
 public:
  SchemaWalk(const std::function<void(const SchemaFact&)>& tell, std::string_view root)
      : tell_(tell), urdf_(root == "robot"), mjcf_(root == "mujoco") {}

  /// Looks through the includes of MJCF, too.
  void follow(const Included& included) { included_ = &included; }

  void element(xml::Element element, const Node& node) {
    if (!element.attributes().empty() || node.requires_attributes()) attributes(element, node);
    if (node.open()) return;
    children(element, node);
    value(element, node);
  }

 private:
  void add(const SchemaFact& fact) { tell_(fact); }

  void attributes(xml::Element element, const Node& node) {
    for (const xml::Attribute attribute : element.attributes()) {
      const std::string_view name = attribute.name();
      if (const auto known = node.attribute(name)) {
        attribute_value(element, attribute, *known);
      } else if (!is_foreign(name) && name != "xmlns") {
        unknown_attribute(element, attribute, node);
      }
    }
    if (node.requires_attributes()) missing_attributes(element, node);
  }

  void missing_attributes(xml::Element element, const Node& node) {
    for (const Node required : node.required_attributes()) {
      if (!element.attribute(required.name())) {
        add({.kind = Kind::kMissingAttribute,
             .where = element.tag_span(),
             .element = element,
             .node = required,
             .parent = node});
      }
    }
  }

  void attribute_value(xml::Element element, xml::Attribute attribute, const Node& known) {
    if (known.deprecated_since()) {
      add({.kind = Kind::kDeprecated,
           .where = attribute.name_span(),
           .element = element,
           .attribute = attribute,
           .node = known,
           .text = attribute.value()});
    }
    typed({element, attribute, attribute.value()}, known, known.type());
  }

  void unknown_attribute(xml::Element element, xml::Attribute attribute, const Node& node) {
    const std::string_view name = attribute.name();
    SchemaFact fact{.kind = Kind::kUnknownAttribute,
                    .where = attribute.name_span(),
                    .element = element,
                    .attribute = attribute,
                    .parent = node};
    if (const auto other = node.attribute_in_other_version(name)) {
      fact.kind =
          other->since() > node.version() ? Kind::kNewerThanVersion : Kind::kRemovedInVersion;
      fact.node = other;
    } else if (const auto child = node.child(name)) {
      fact.kind = Kind::kElementAsAttribute;
      fact.node = child;
    } else {
      for (const Node candidate : node.attributes()) {
        if (!equal_but_for_case(candidate.name(), name)) continue;
        fact.kind = Kind::kWrongCase;
        fact.node = candidate;
      }
    }
    add(fact);
    // As of an element: consumers read its value with their newest schema.
    if (fact.kind == Kind::kNewerThanVersion) attribute_value(element, attribute, *fact.node);
  }

  void children(xml::Element element, const Node& node) {
    const std::size_t others = seen_.size();
    each_child(others, element, node);
    if (node.requires_children() && !element.cut()) missing_children(others, element, node);
    seen_.erase(seen_.begin() + static_cast<std::ptrdiff_t>(others), seen_.end());
  }

  void each_child(std::size_t others, xml::Element element, const Node& node) {
    for (const xml::Element child : element.children()) {
      const std::string_view name = child.name();
      if (included_ != nullptr && name == "include") {
        if (const auto part = (*included_)(child)) each_child(others, *part, node);
      }
      if (const auto known = node.child(name)) {
        repeated(others, child, *known);
        if (known->deprecated_since()) {
          add({.kind = Kind::kDeprecated,
               .where = child.name_span(),
               .element = child,
               .node = known,
               .parent = node});
        }
        this->element(child, *known);
      } else if (!is_foreign(name)) {
        unknown_element(child, node);
      }
    }
  }

  void missing_children(std::size_t others, xml::Element element, const Node& node) {
    for (const Node required : node.required_children()) {
      if (first_of(others, required) != seen_.end()) continue;
      add({.kind = Kind::kMissingElement,
           .where = element.tag_span(),
           .element = element,
           .node = required,
           .parent = node});
    }
  }

  /// Only the first of its name can be read where one is allowed; told once, at the second.
  /// `others` is where those of the same parent begin in `seen_`.
  void repeated(std::size_t others, xml::Element child, const Node& known) {
    const auto first = first_of(others, known);
    if (first == seen_.end()) return seen_.push_back({child, known.place()});
    const Cardinality cardinality = known.cardinality();
    if (cardinality == Cardinality::kMany || cardinality == Cardinality::kOneOrMore) return;
    if (std::exchange(first->told, true)) return;
    add({.kind = Kind::kRepeatedElement,
         .where = child.name_span(),
         .element = child,
         .node = known,
         .related = first->element.name_span()});
  }

  void unknown_element(xml::Element child, const Node& node) {
    const std::string_view name = child.name();
    SchemaFact fact{.kind = Kind::kUnknownElement,
                    .where = child.name_span(),
                    .element = child,
                    .parent = node};
    if (const auto other = node.child_in_other_version(name)) {
      fact.kind =
          other->since() > node.version() ? Kind::kNewerThanVersion : Kind::kRemovedInVersion;
      fact.node = other;
    } else if (const auto attribute = node.attribute(name)) {
      fact.kind = Kind::kAttributeAsElement;
      fact.node = attribute;
    } else {
      for (const Node candidate : node.children()) {
        if (!equal_but_for_case(candidate.name(), name)) continue;
        fact.kind = Kind::kWrongCase;
        fact.node = candidate;
      }
    }
    add(fact);
    // Consumers read an old file with their newest schema, so what is inside counts all the same.
    if (fact.kind == Kind::kNewerThanVersion) this->element(child, *fact.node);
  }

  void value(xml::Element element, const Node& node) {
    const Span lost = element.lost_text();
    const Type type = node.type();
    const bool takes_text = type != Type::kNone;
    const std::string_view text = element.text();
    if (!lost.nowhere()) {
      add({.kind = Kind::kLostText, .where = lost, .element = element, .node = node});
    } else if (!takes_text && !trimmed(text).empty()) {
      add({.kind = Kind::kLostText,
           .where = element.text_span(),
           .element = element,
           .node = node});
    }
    // An element without a value takes its default; whether it may stands with the type.
    if (takes_text) typed({element, std::nullopt, text}, node, type);
  }

  /// The value of an attribute, or of the element when it is about none.
  struct Value {
    xml::Element element;
    std::optional<xml::Attribute> attribute;
    std::string_view text;
  };

  void typed(const Value& given, const Node& node, Type type) {
    const std::string_view text = given.text;
    if (mjcf_) {
      if (const auto count = node.count()) {
        if (!numbers(given, node, *count) || trimmed(text).empty()) return;
        if (count->most != 1) type = Type::kString;
      }
    }
    if (type != Type::kString) {
      const bool pose = type == Type::kPose && !given.attribute;
      const auto format = pose ? rotation_format(given.element) : schema::RotationFormat::kEulerRpy;
      if (const auto fault = checked(type, text, format)) {
        SchemaFact fact = about(Kind::kBadValue, given, node);
        const bool verbatim =
            given.attribute ? given.attribute->verbatim() : given.element.text_verbatim();
        if (verbatim) {
          fact.where.end = fact.where.begin + static_cast<std::uint32_t>(fault->end);
          fact.where.begin += static_cast<std::uint32_t>(fault->begin);
        }
        fact.value_fault = fault;
        return add(fact);
      }
      if (is_number(type) && has_a_name(text) && !takes_form(schema::classify(text))) {
        SchemaFact fact = about(Kind::kBadValue, given, node);
        fact.value_fault = {schema::ValueFault::Kind::kNotFinite, 0, text.size()};
        return add(fact);
      }
    }
    if (!node.may_have_limits()) return;
    // MuJoCo takes a keyword with the spaces around it.
    const std::string_view value = mjcf_ && type == Type::kString ? text : trimmed(text);
    // What the schema writes as its own default is never out of its own bounds or list.
    const schema::Enumeration list = node.enumeration();
    // MuJoCo takes an empty keyword for an unknown one.
    if (!list.empty() && (mjcf_ || !value.empty()) && !list.contains(value)) {
      return add(about(Kind::kNotInEnumeration, given, node));
    }
    if (is_number(type) && (node.minimum() || node.maximum()) && outside(value, node)) {
      add(about(Kind::kOutOfRange, given, node));
    }
  }

  /// Whether the text is as many numbers as it may be. MuJoCo reads an empty one as none.
  bool numbers(const Value& given, const Node& node, const schema::Count& count) {
    const auto list = mjcf_numbers(given.text);
    const bool whole = node.type() == Type::kInt;
    if (!list || (whole && !is_list_of_integers(given.text))) {
      add(about(Kind::kNotNumbers, given, node));
      return false;
    }
    if (list->empty() || count.allows(list->size())) return true;
    add(about(Kind::kNumberCount, given, node));
    return false;
  }

  static bool is_list_of_integers(std::string_view numbers) {
    const auto is_integer = [](std::string_view word) {
      if (word.starts_with('+')) word.remove_prefix(1);
      int value = 0;
      const char* const end = word.data() + word.size();
      const auto [stop, error] = std::from_chars(word.data(), end, value);
      return error == std::errc() && stop == end;
    };
    constexpr std::string_view kSpace = " \t\r\n";
    while (true) {
      numbers.remove_prefix(std::min(numbers.find_first_not_of(kSpace), numbers.size()));
      if (numbers.empty()) return true;
      const std::string_view word = numbers.substr(0, numbers.find_first_of(kSpace));
      if (!is_integer(word)) return false;
      numbers.remove_prefix(word.size());
    }
  }

  /// urdfdom takes a color only with its alpha: with three numbers it is black, without a word.
  std::optional<schema::ValueFault> checked(Type type, std::string_view text,
                                            schema::RotationFormat format) const {
    constexpr std::size_t kOfColor = 4;
    const auto fault = schema::check(type, text, format);
    if (fault || !urdf_ || type != Type::kColor || words_in(text) == kOfColor) return fault;
    return schema::ValueFault{schema::ValueFault::Kind::kTooFew, 0, text.size()};
  }

  static SchemaFact about(Kind kind, const Value& given, const Node& node) {
    const auto& attribute = given.attribute;
    return {.kind = kind,
            .where = attribute ? attribute->value_span() : given.element.text_span(),
            .element = given.element,
            .attribute = attribute,
            .node = node,
            .text = given.text};
  }

  /// Whether it could be inf, nan or hexadecimal: a quick look, as nearly no number is.
  static bool has_a_name(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size() && (text[at] <= ' ' || text[at] == '+' || text[at] == '-')) ++at;
    return at + 1 < text.size() && (text[at] > '9' || (text[at + 1] | 0x20) == 'x');
  }

  /// Whether consumers take a number of this form. Nobody means nan; urdfdom reads numbers through a
  /// stream, which knows neither inf nor hexadecimal ones.
  bool takes_form(const schema::NumberForm& form) const {
    return !form.nan && !(urdf_ && (form.infinite || form.hexadecimal));
  }

  static bool outside(std::string_view value, const Node& node) {
    const auto number = [](std::string_view text) {
      const auto parsed = schema::parse_double(text);
      const double* found = std::get_if<double>(&parsed);
      return found != nullptr ? *found : 0.0;
    };
    const double given = number(value);
    return (node.minimum() && given < number(*node.minimum())) ||
           (node.maximum() && given > number(*node.maximum()));
  }

  /// The first of a name that the schema knows here.
  struct Seen {
    xml::Element element;
    std::uint32_t place;
    bool told = false;
  };

  std::vector<Seen>::iterator first_of(std::size_t others, const Node& known) {
    return std::find_if(seen_.begin() + static_cast<std::ptrdiff_t>(others), seen_.end(),
                        [&known](const Seen& seen) { return seen.place == known.place(); });
  }

  const std::function<void(const SchemaFact&)>& tell_;
  std::vector<Seen> seen_;  // of the elements that are open, one parent's after the other's
  const Included* included_ = nullptr;
  bool urdf_;
  bool mjcf_;
};

}  // namespace

void check_conformance(const xml::Document& document, const schema::Node& root,
                       const std::function<void(const SchemaFact&)>& tell,
                       const Included& included) {
  const auto element = document.root();
  if (!element) return;
  SchemaWalk walk(tell, root.name());
  if (included) walk.follow(included);
  walk.element(*element, root);
}

void check_conformance(xml::Element element, const schema::Node& node,
                       const std::function<void(const SchemaFact&)>& tell) {
  SchemaWalk(tell, {}).element(element, node);
}

}  // namespace rigor::read
