// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of xacro in one document as it is written: macros, their parameters, properties and arguments, where
// they are defined and where they are used.
//
//   for (const TemplateName& name : template_names(document)) if (name.defines) …
//
// Two are the same thing when kind, owner and name are. A property is examined as one of the file, wherever it
// is set.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::author {

enum class TemplateNameKind : std::uint8_t { kMacro, kParameter, kProperty, kArgument };

std::string_view to_string(TemplateNameKind kind);

struct TemplateName {
  TemplateNameKind kind = TemplateNameKind::kProperty;
  std::string owner;  ///< of a parameter, its macro's name
  std::string name;
  Span where;
  Span also = {};  ///< of a macro's call with content, the name in its end tag
  Span element = {};
  bool defines = false;
  bool is_block = false;  ///< of a parameter's definition: its value is an element of the call

  bool same_as(const TemplateName& other) const {
    return kind == other.kind && owner == other.owner && name == other.name;
  }
};

/// In the order of their places.
std::vector<TemplateName> template_names(const xml::Document& document);

}  // namespace rigor::author
