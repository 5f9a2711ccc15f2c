// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What xacro would have replaced, had it been run.

#pragma once

#include <cstddef>
#include <string_view>

#include <rigor/model/parameter.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// Whether a value still has xacro's `${…}` or `$(…)` in it.
inline bool has_xacro(std::string_view value) {
  for (std::size_t at = value.find('$'); at != std::string_view::npos; at = value.find('$', at)) {
    ++at;
    if (at < value.size() && (value[at] == '{' || value[at] == '(')) return true;
  }
  return false;
}

/// Whether xacro was to put parts into the element: what it lacks may be among them.
inline bool has_xacro_child(xml::Element element) {
  for (const xml::Element child : element.children()) {
    if (child.name().starts_with("xacro:")) return true;
  }
  return false;
}

inline bool has_xacro_child(const model::Parameter& parameter) {
  for (const model::Parameter& child : parameter.children) {
    if (child.name.starts_with("xacro:")) return true;
  }
  return false;
}

}  // namespace rigor::rules
