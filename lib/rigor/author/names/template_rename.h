// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Another name for a macro, a parameter, a property or an argument of templates, as byte edits.
//
//   const Renaming renaming = renamed_in_templates(context, {"robot.urdf.xacro"}, name, "wheel_radius");
//
// Every template that reads a file with the name is expanded before and after: that must give the same, or
// nothing is renamed.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/rename.h>
#include <rigor/author/names/template_names.h>

namespace rigor::author {

/// A name of a file that a template reads, as it is written there.
struct TemplateUse {
  TemplateName name;
  Span where;  ///< in the file's source; the end tag's, too, is one
};

/// The uses of a name in all files that a template reads.
std::vector<TemplateUse> template_uses(const read::File& file, const Sources& sources,
                                       const TemplateName& name);

Renaming renamed_in_templates(const RenameContext& context,
                              const std::vector<std::string>& templates, const TemplateName& name,
                              std::string_view new_name);

}  // namespace rigor::author
