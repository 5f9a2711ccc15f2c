// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A value of a template as a property, and a property as the values that it represents.
//
//   extracted_property(context, files, value, "wheel_radius");  // radius="0.3" → radius="${wheel_radius}"
//   inlined_property(context, files, name);                     // and back
//
// Every template that reads the file is expanded before and after: that must give the same, or nothing is changed.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/rename.h>
#include <rigor/author/names/template_names.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// What a place of a template can be made a property of: the value of the attribute there, or the number where the
/// place is in an expression. Nowhere where it is neither.
Span extractable_value(const xml::Document& document, Span selection);

/// "cylinder_radius", of the attribute that has the value; one that nothing in the document has.
std::string proposed_property(const xml::Document& document, Span value);

/// A property of the value, set before the part of the file that has it; `templates` are those of the workspace.
Renaming extracted_property(const RenameContext& context, const std::vector<std::string>& templates,
                            const xml::Document& document, Span value, std::string_view name);

/// The value of a property wherever it is used, and the property gone.
Renaming inlined_property(const RenameContext& context, const std::vector<std::string>& templates,
                          const TemplateName& name);

}  // namespace rigor::author
