// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names that no version of a format has and that known consumers read all the same (schema/dialect.h).

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/rules/context.h>
#include <rigor/schema/dialect.h>

namespace rigor::rules {

inline std::string_view dialect_format(const Context& context) {
  return context.is_urdf() ? "urdf" : "sdf";
}

/// The consumer that reads an element or attribute that the format does not have.
inline std::optional<std::string_view> dialect_reader(const read::SchemaFact& fact,
                                                      const Context& context) {
  if (!fact.parent) return std::nullopt;
  const std::string name =
      fact.attribute ? "@" + std::string(fact.attribute->name()) : std::string(fact.element.name());
  return schema::find_dialect(dialect_format(context), fact.parent->name(), name);
}

/// Whether the robot was written for Bullet: a link has contact constants, or concave triangles, that only Bullet
/// reads. It computes tensors from the collisions, fixes links of mass 0, and frees joints whose limits are inverted.
inline bool is_for_bullet(const Context& context) {
  if (!context.is_urdf()) return false;
  const model::Root& root = context.root();
  return std::any_of(root.links.begin(), root.links.end(), [&](const model::Link& link) {
    if (!root.own(link.site)) return false;
    const xml::Element element = context.element(link.site);
    if (element.attribute("concave")) return true;
    const auto contact = element.child("contact");
    if (!contact) return false;
    for (const xml::Element child : contact->children()) {
      if (schema::find_dialect("urdf", "contact", child.name())) return true;
    }
    return false;
  });
}

}  // namespace rigor::rules
