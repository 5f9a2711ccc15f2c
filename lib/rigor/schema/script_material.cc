// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/schema/script_material.h>

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include <rigor/schema/embedded.h>
#include <rigor/schema/value.h>

namespace rigor::schema {
namespace {

std::string_view column_text(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  while (true) {
    const std::size_t end = line.find('|');
    columns.push_back(column_text(line.substr(0, end)));
    if (end == std::string_view::npos) return columns;
    line.remove_prefix(end + 1);
  }
}

template <class Color>
bool take_color(const Parsed<Color>& parsed, Color& color) {
  const Color* value = std::get_if<Color>(&parsed);
  if (value != nullptr) color = *value;
  return value != nullptr;
}

}  // namespace

std::optional<ScriptMaterial> find_material(std::string_view text, std::string_view name) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (name.empty() || !line.starts_with(name) || line[0] == '#') continue;
    const auto columns = columns_of(line);
    ScriptMaterial found{.name = columns[0]};
    if (found.name != name || columns.size() < 4) continue;
    if (!take_color(parse_vector3(columns[1]), found.ambient) ||
        !take_color(parse_color(columns[2]), found.diffuse) ||
        !take_color(parse_vector3(columns[3]), found.specular)) {
      continue;
    }
    if (columns.size() > 4) found.texture = columns[4];
    return found;
  }
  return std::nullopt;
}

std::optional<ScriptMaterial> find_material(std::string_view name) {
  return find_material(gazebo_materials_text(), name);
}

}  // namespace rigor::schema
