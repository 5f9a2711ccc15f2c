// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What libsdformat 12 knows of the elements that parameters of an `<include>` hold.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/schema/schema.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// The description that a parameter of that name is read by. libsdformat looks for a file of the name
/// (`visual.sdf`): `<geometry>` has one, `<mass>` and `<box>` have none.
std::optional<schema::Node> description_of(const schema::Node& sdf, std::string_view name);

/// The description of an element by the elements around it.
std::optional<schema::Node> description_of(const schema::Node& sdf, xml::Element element);

/// Why libsdformat cannot read the element, in words; nothing where it can. It does not mind unknown names,
/// text behind a number, or a value out of range.
std::optional<std::string> unreadable_content(xml::Element element, const schema::Node& node);

/// Whether libsdformat takes the text as a value of the element.
bool takes_value(const schema::Node& node, std::string_view text);

}  // namespace rigor::read
