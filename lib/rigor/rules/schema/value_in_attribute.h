// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is the text of an element in SDF, and stands in an attribute of it as in URDF or SDF 1.0:
// `<mass value="2"/>`, `<parent link="a"/>`.

#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/rules/edits.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/value.h>
#include <rigor/xml/edit.h>

namespace rigor::rules {

/// Whether the attribute, which has no effect, holds the value that the element lacks. `node` is the
/// element's.
inline bool holds_value(xml::Attribute attribute, xml::Element element, const schema::Node& node) {
  const std::string_view name = attribute.name();
  if (node.type() == schema::Type::kNone || node.attribute(name)) return false;
  if (name != "value" && !node.attribute_in_other_version(name)) return false;
  if (!element.children().empty() || !read::trimmed(element.text()).empty()) return false;
  return !read::trimmed(attribute.value()).empty() &&
         !schema::check(node.type(), attribute.value());
}

inline std::optional<Fix> value_as_text(xml::Attribute attribute, xml::Element element,
                                        const Context& context) {
  std::vector<Edit> edits = xml::remove_attribute(context.document(), attribute);
  append(edits, xml::set_text(context.document(), element, attribute.value()));
  return fix_of("write the value between the tags", Applicability::kUnsafe, std::move(edits));
}

}  // namespace rigor::rules
