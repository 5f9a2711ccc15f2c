// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/expansion.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include <rigor/report/json/values.h>
#include <rigor/report/places.h>

namespace rigor::report {
namespace {

Json place_in(Span where, Places& places) {
  if (where.nowhere()) return nullptr;
  const Position begin = places.begin(where), end = places.end(where);
  return {{"path", places.path(where)},
          {"line", begin.line},
          {"column", begin.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

void add_expanded(const xacro::Node& node, const std::string& path, Places& places,
                  Json& elements) {
  Json element{{"path", path}, {"where", place_in(node.where.span, places)}, {"frame", node.frame}};
  Json attributes = Json::object();
  for (const xacro::NodeAttribute& attribute : node.attributes) {
    Json& at = attributes[std::string(attribute.name)];
    at = {{"value", attribute.value}, {"where", place_in(attribute.where.span, places)}};
    if (!attribute.from.nowhere()) at["from"] = place_in(attribute.from, places);
  }
  element["attributes"] = std::move(attributes);
  elements.push_back(std::move(element));
  std::map<std::string_view, std::size_t> counts;
  for (const xacro::Node* child = node.first_element(); child != nullptr;
       child = child->next_element()) {
    const std::size_t number = ++counts[child->name];
    add_expanded(*child, path + '/' + std::string(child->name) + '[' + std::to_string(number) + ']',
                 places, elements);
  }
}

}  // namespace

std::string expansion_json(const xacro::Expansion& expansion, const Sources& sources) {
  Places places(sources);
  Json json{{"schema_version", 1}, {"files", Json::array()}, {"frames", Json::array()}};
  for (const xacro::FileUse& file : expansion.files) json["files"].push_back(file.path);
  for (const xacro::Frame& frame : expansion.frames) {
    Json parameters = Json::object();
    for (std::uint32_t i = 0; i < frame.parameter_count; ++i) {
      const auto& [name, value] = expansion.frame_parameters[frame.parameters + i];
      parameters[std::string(name)] = xacro::shown_value(value);
    }
    json["frames"].push_back({{"kind", xacro::name_of(frame.kind)},
                              {"name", frame.name},
                              {"outer", frame.outer},
                              {"where", place_in(frame.where, places)},
                              {"parameters", std::move(parameters)}});
  }
  Json elements = Json::array();
  if (expansion.root != nullptr) {
    add_expanded(*expansion.root, '/' + std::string(expansion.root->name), places, elements);
  }
  json["elements"] = std::move(elements);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
