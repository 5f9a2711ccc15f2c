// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A missing element and an unknown one are one fault when the one is the other, misspelt.

#pragma once

#include <optional>
#include <string_view>

#include <rigor/rules/context.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/suggest.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// The child that no element of the format is called, and that was probably meant to be `name`.
inline std::optional<xml::Element> misspelt_child(xml::Element element, std::string_view name,
                                                  const Context& context) {
  if (context.schema() == nullptr) return std::nullopt;
  for (const xml::Element child : element.children()) {
    if (schema::near(child.name(), {name}).empty()) continue;
    if (context.schema()->parents_of(child.name(), {context.root().version}).empty()) return child;
  }
  return std::nullopt;
}

inline std::optional<xml::Element> misspelt_child(const model::Site& site, std::string_view name,
                                                  const Context& context) {
  return misspelt_child(context.element(site), name, context);
}

/// Whether a child has the name, or one that is near to it.
inline bool has_near_child(const model::Site& site, std::string_view name, const Context& context) {
  for (const xml::Element child : context.element(site).children()) {
    if (child.name() == name || !schema::near(child.name(), {name}).empty()) return true;
  }
  return false;
}

inline bool has_child(const model::Site& site, std::string_view name, const Context& context) {
  return context.element(site).child(name).has_value();
}

inline bool has_any_child(const model::Site& site, const Context& context) {
  return !context.element(site).children().empty();
}

/// Whether xacro was to put parts into the element: what it lacks may be among them.
inline bool has_xacro_child(const model::Site& site, const Context& context) {
  return has_xacro_child(context.element(site));
}

/// Whether a consumer refuses or misreads the file where `parent` lacks this required child: then
/// `missing-element` reports it, misspelt or not. libsdformat takes the default of most.
inline bool is_needed(std::string_view parent, std::string_view child, const Context& context) {
  if (context.is_urdf()) return true;
  if (parent == "joint") return child == "parent" || child == "child";
  return (parent == "mesh" || parent == "heightmap" || parent == "image") && child == "uri";
}

}  // namespace rigor::rules
