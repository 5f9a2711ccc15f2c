// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Speaks of the place in a file that a schema's fact is about.

#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/rules/context.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules {

/// What a diagnostic is about, from the names around an element: "arm::hand/link palm".
inline std::string subject_of(xml::Element element) {
  constexpr std::array<std::string_view, 8> kKinds = {"link",   "joint", "frame",  "collision",
                                                      "visual", "light", "sensor", "plugin"};
  std::string models;
  std::string inside;
  for (std::optional<xml::Element> at = element; at; at = at->parent()) {
    const auto name = at->attribute("name");
    if (!name) continue;
    const std::string value(name->value());
    if (at->name() == "model" || at->name() == "robot") {
      models = models.empty() ? value : value + "::" + models;
    } else if (std::find(kKinds.begin(), kKinds.end(), at->name()) != kKinds.end()) {
      inside = "/" + std::string(at->name()) + " " + value + inside;
    } else if (at->name() == "world" && models.empty()) {
      models = "world " + value;
    }
  }
  return models.empty() && !inside.empty() ? inside.substr(1) : models + inside;
}

/// "SDF 1.9", "URDF".
inline std::string format_and_version(const Context& context, schema::Version version) {
  return context.is_urdf() ? "URDF" : "SDF " + schema::to_string(version);
}

inline std::vector<std::string_view> node_names(const schema::NodeRange& nodes) {
  std::vector<std::string_view> names;
  for (const schema::Node node : nodes) names.push_back(node.name());
  return names;
}

/// Whether a URDF's readers take the element without what the schema requires of it, so that `missing-attribute` says
/// nothing: urdfdom ignores a color or texture without a value, and reads no sensors.
inline bool may_lack_attributes(std::string_view element, const Context& context) {
  return context.is_urdf() && (element == "color" || element == "texture" || element == "sensor");
}

/// The missing required attribute that an unknown one was probably meant to be; `missing-attribute`
/// then reports both.
inline std::optional<std::string_view> meant_for_missing(const read::SchemaFact& fact,
                                                         std::string_view written) {
  if (!fact.parent) return std::nullopt;
  for (const schema::Node required : fact.parent->required_attributes()) {
    if (fact.element.attribute(required.name())) continue;
    if (!schema::near(written, {required.name()}).empty()) return required.name();
  }
  return std::nullopt;
}

/// Whether a child element is written as an attribute, as SDF 1.0 had it: `element-as-attribute`
/// then reports it.
inline bool written_as_attribute(const read::SchemaFact& fact) {
  return fact.attribute && fact.parent && fact.parent->child(fact.attribute->name());
}

}  // namespace rigor::rules
