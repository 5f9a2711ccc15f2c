// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Holds a document against its format's schema: one walk over the elements, facts where they differ.
//
// The facts say what is so; a rule turns each kind into words. Elements and attributes with a colon
// in their names belong to somebody else, and what stands inside a `<plugin>` to the plugin: neither
// is examined.
//
//   check_conformance(document, *schema.root("sdf", version),
//                     [](const SchemaFact& fact) { speak_of(fact); });

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include <rigor/schema/schema.h>
#include <rigor/schema/value.h>
#include <rigor/xml/document.h>

namespace rigor::read {

enum class SchemaFactKind : std::uint8_t {
  kUnknownElement,  ///< to this version, here; it may belong elsewhere
  kUnknownAttribute,
  kWrongCase,           ///< known here but for letter case; `node` is the right one
  kNewerThanVersion,    ///< known here in a later version; `node` is that one
  kRemovedInVersion,    ///< known here in an earlier version; `node` is that one
  kAttributeAsElement,  ///< an attribute of the parent, written as a child; `node` is the attribute
  kElementAsAttribute,  ///< a child of the element, written as an attribute; `node` is the child
  kMissingAttribute,    ///< required; `node` is it
  kMissingElement,      ///< required; `node` is it
  kRepeatedElement,     ///< `related` is the first
  kBadValue,            ///< of an element or attribute: see `value_fault`
  kNotNumbers,          ///< where the schema has a count of numbers
  kNumberCount,         ///< too few or too many of them
  kNotInEnumeration,
  kOutOfRange,  ///< below or above the schema's bounds
  kDeprecated,
  kLostText,  ///< characters no consumer reads
};

struct SchemaFact {
  SchemaFactKind kind;
  Span where;            ///< the name, value or text at fault
  xml::Element element;  ///< the element at fault, or the one that lacks something
  std::optional<xml::Attribute> attribute;  ///< when the fact is about one
  std::optional<schema::Node> node;         ///< what the schema says; see the kinds
  std::optional<schema::Node> parent;       ///< the schema's node of the parent element
  std::optional<schema::ValueFault> value_fault;
  Span related;
  std::string_view text;  ///< the value at fault, decoded

  /// The name of the element that `element` is in (1), of the one around that (2), …; empty above the root.
  std::string_view ancestor(std::size_t levels) const;
  bool is_inside(std::string_view name) const;    ///< of an ancestor
  bool has_child(std::string_view name) const;    ///< of `element`
  bool has_sibling(std::string_view name) const;  ///< of `element`, or it itself
};

/// The root of the file that an `<include>` of MJCF is replaced by; nothing where it leads nowhere.
using Included = std::function<std::optional<xml::Element>(xml::Element include)>;

/// Gives `tell` the facts in document order: one at a time, since a file may have as many as it has
/// elements. Of an element that a fatal XML fault cut, nothing is said to be missing.
/// What MJCF includes is looked at in its place, where `included` finds it.
void check_conformance(const xml::Document& document, const schema::Node& root,
                       const std::function<void(const SchemaFact&)>& tell,
                       const Included& included = {});

/// The same of one element and what it holds, which the schema has as `node`: SDF in a URDF.
void check_conformance(xml::Element element, const schema::Node& node,
                       const std::function<void(const SchemaFact&)>& tell);

}  // namespace rigor::read
