// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a format's schema says of the element that a row of open elements leads to, in the document's own version.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/environment.h>
#include <rigor/schema/schema.h>

namespace rigor::lsp {

/// `path` are the names of elements, the root first; `version` the root's attribute, which may be empty. Tags of
/// xacro are passed over; what is in <gazebo> of a URDF is looked up in SDF's link, joint and model. Nothing
/// where no schema knows the place.
std::optional<schema::Node> schema_place(const Environment& environment,
                                         const std::vector<std::string_view>& path,
                                         std::string_view version);

/// Markdown: what the element or attribute is, its type, default, unit and versions.
std::string schema_text(const schema::Node& node);

}  // namespace rigor::lsp
