// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/moved_paths.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <rigor/read/values.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using Names = std::pair<std::string_view, std::string_view>;

/// Elements, with what they are in, whose text is a URI.
constexpr std::array<Names, 12> kTexts{{{"mesh", "uri"},
                                        {"heightmap", "uri"},
                                        {"image", "uri"},
                                        {"include", "uri"},
                                        {"script", "uri"},
                                        {"texture", "diffuse"},
                                        {"texture", "normal"},
                                        {"metal", "albedo_map"},
                                        {"metal", "normal_map"},
                                        {"metal", "roughness_map"},
                                        {"metal", "metalness_map"},
                                        {"metal", "emissive_map"}}};
/// Elements with a URI in an attribute.
constexpr std::array<Names, 3> kAttributes{
    {{"mesh", "filename"}, {"texture", "filename"}, {"xacro:include", "filename"}}};

/// A path with an expression of xacro is left as it is.
std::string moved_path(const std::string& uri, std::string_view from, std::string_view to) {
  if (uri.empty() || uri.find("://") != std::string::npos || uri.find('$') != std::string::npos ||
      is_absolute(uri) || normalize_path(from) == normalize_path(to))
    return uri;
  return relative_path(to, join_path(from, uri));
}

}  // namespace

std::vector<Edit> moved_paths(const xml::Document& document, std::string_view path,
                              std::string_view folder) {
  std::vector<Edit> edits;
  const auto move = [&](std::string_view value, Span where) {
    const std::string uri(value);
    const std::string moved = moved_path(uri, parent_path(path), folder);
    if (moved != uri) edits.push_back({where, xml::escaped(moved)});
  };
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const auto parent = element.parent();
    const Names names{parent ? parent->name() : std::string_view(), element.name()};
    if (std::find(kTexts.begin(), kTexts.end(), names) != kTexts.end()) {
      const std::string_view value = read::trimmed(element.text());
      Span where = element.text_span();
      if (element.text_verbatim()) {
        where.begin += static_cast<std::uint32_t>(value.data() - element.text().data());
        where.end = where.begin + static_cast<std::uint32_t>(value.size());
      }
      move(value, where);
    }
    for (const Names& each : kAttributes) {
      const auto attribute = element.attribute(each.second);
      if (element.name() == each.first && attribute)
        move(attribute->value(), attribute->value_span());
    }
  }
  return edits;
}

void move_paths(robot::Robot& robot, const EditedModel& of, std::string_view folder) {
  for (robot::Body& body : robot.bodies) {
    for (auto* parts : {&body.collisions, &body.visuals}) {
      for (robot::Part& each : *parts)
        each.shape.uri = moved_path(each.shape.uri, parent_path(of.path()), folder);
    }
  }
}

std::string moved_text(const std::string& text, std::string_view path, std::string_view out) {
  const std::vector<Edit> edits = moved_paths(xml::parse_own(text, {}), path, parent_path(out));
  return apply_edits(text, edits).value_or(text);
}

}  // namespace rigor::author
