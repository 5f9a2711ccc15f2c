// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files beside meshes that a model names: textures, height maps, material scripts, skins.

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// "texture", "height map", …; empty when the element names no such file.
inline std::string_view kind_of_asset(xml::Element element) {
  const std::string_view name = element.name();
  const auto stands_in = [element](std::string_view parent) {
    const auto above = element.parent();
    return above && above->name() == parent;
  };
  if (name == "uri") {
    if (stands_in("script")) {
      const auto above = element.parent()->parent();
      return above && above->name() == "material" ? "material file or folder" : "";
    }
    if (stands_in("heightmap")) return "height map";
    return stands_in("image") ? "image" : "";
  }
  if (name == "filename") {
    if (stands_in("skin")) return "skin";
    return stands_in("animation") ? "animation" : "";
  }
  if (name == "color_range_image") return stands_in("particle_emitter") ? "image" : "";
  const bool texture = (name == "texture" && (stands_in("material") || stands_in("projector"))) ||
                       (name == "cubemap_uri" && stands_in("sky")) ||
                       ((name == "diffuse" || name == "normal") && stands_in("texture")) ||
                       (name.ends_with("_map") && (stands_in("metal") || stands_in("specular")));
  return texture ? "texture" : "";
}

/// Whether an element names a file, or is one of `uri`, `mesh`, `texture` and `script`, which stand around such
/// a name or hold it. Its first letter tells of nearly all that they are not.
inline bool is_about_files(xml::Element element) {
  const std::string_view name = element.name();
  switch (name.empty() ? '\0' : name.front()) {
    case 'm':
      if (name == "mesh") return true;
      break;
    case 's':
      if (name == "script") return true;
      break;
    case 't': return name == "texture";
    case 'u': return name == "uri";
    case 'c':
    case 'd':
    case 'f':
    case 'n': return !kind_of_asset(element).empty();
  }
  return name.ends_with("_map") && !kind_of_asset(element).empty();
}

/// Those of a file, found in one walk: every element has to be asked, and nearly none is.
inline std::vector<xml::Element> elements_about_files(const xml::Document& document) {
  std::vector<xml::Element> found;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    if (is_about_files(element)) found.push_back(element);
  }
  return found;
}

/// The text of such an element; of URDF's <texture> the filename.
inline std::optional<read::Text> asset_uri(xml::Element element) {
  if (const auto file = read::value_attribute(element, "filename")) return file;
  if (!element.children().empty()) return std::nullopt;
  return read::Text{element.text(), element.text_span()};
}

}  // namespace rigor::rules
