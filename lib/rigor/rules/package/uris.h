// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The URIs that a file holds, wherever they stand.

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/rules/package/assets.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

struct Uri {
  std::string_view text;  ///< decoded, without the white space around it
  Span where;
  bool verbatim;  ///< whether the text is the file's own bytes
};

/// Of includes, meshes, textures, scripts, heightmaps and actors; not of plugins, which may mean anything.
inline std::vector<Uri> uris_of(const std::vector<xml::Element>& elements_about_files) {
  std::vector<Uri> uris;
  const auto add = [&uris](std::string_view text, Span span, bool verbatim) {
    const std::string_view inner = read::trimmed(text);
    if (inner.empty() || has_xacro(inner)) return;
    if (verbatim) {
      span.begin += static_cast<std::uint32_t>(inner.data() - text.data());
      span.end = span.begin + static_cast<std::uint32_t>(inner.size());
    }
    uris.push_back({inner, span, verbatim});
  };
  const auto in_plugin = [](xml::Element element) {
    for (auto at = element.parent(); at; at = at->parent()) {
      if (at->name() == "plugin" || at->name() == "gazebo") return true;
    }
    return false;
  };
  for (const xml::Element element : elements_about_files) {
    const std::string_view name = element.name();
    const bool is_uri = name == "uri" || name == "texture" || !kind_of_asset(element).empty();
    if (is_uri && element.children().empty() && !in_plugin(element)) {
      add(element.text(), element.text_span(), element.text_verbatim());
    }
    if (name != "mesh" && name != "texture") continue;
    const auto file = element.attribute("filename");
    if (file && read::values_are_attributes(element) && !in_plugin(element)) {
      add(file->value(), file->value_span(), file->verbatim());
    }
  }
  return uris;
}

}  // namespace rigor::rules
