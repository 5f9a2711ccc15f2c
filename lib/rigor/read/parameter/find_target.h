// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the `element_id` of a parameter of an `<include>` refers to, as `getElementById` of libsdformat 12
// finds it: at each level it follows the longest name that the rest of the text begins with, so
// `sub::link` may be one name or two. A name of one letter is never followed at the first level.

#pragma once

#include <optional>
#include <string_view>

#include <rigor/xml/document.h>

namespace rigor::read {

/// The element of that name below the model; nothing where libsdformat finds none.
std::optional<xml::Element> find_target(xml::Element model, std::string_view element_name,
                                        std::string_view element_id);
/// The one that something is added to: of any element name, and at the first level of one letter too.
std::optional<xml::Element> find_parent_to_add_to(xml::Element model, std::string_view element_id);

/// Whether what an id begins with is a child of the model with a name of one letter.
bool begins_with_one_letter_name(xml::Element model, std::string_view element_id);

/// Whether the id may lead into a model that the model includes.
bool may_lead_into_include(xml::Element model, std::string_view element_id);

}  // namespace rigor::read
