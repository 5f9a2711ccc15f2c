// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/moved_paths.h>

#include <string>
#include <variant>

#include <rigor/text/path.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

std::string moved_path(const std::string& uri, std::string_view from, std::string_view to) {
  if (uri.empty() || uri.find("://") != std::string::npos || is_absolute(uri) ||
      normalize_path(from) == normalize_path(to))
    return uri;
  return rigor::relative_path(to, join_path(from, uri));
}

}  // namespace

std::vector<Edit> moved_paths(const EditedModel& of, std::string_view folder) {
  std::vector<Edit> edits;
  const auto move_uri = [&](const model::Field<std::string>& uri) {
    if (!uri.written || uri.span.nowhere() || uri.span.source != of.document().source()) return;
    const std::string path = moved_path(uri.value, parent_path(of.path()), folder);
    if (path != uri.value) edits.push_back({uri.span, xml::escaped(path)});
  };
  const auto move = [&](const model::Geometry& geometry) {
    if (const auto* mesh = std::get_if<model::Mesh>(&geometry.shape)) move_uri(mesh->uri);
    if (const auto* map = std::get_if<model::Heightmap>(&geometry.shape)) move_uri(map->uri);
    if (const auto* image = std::get_if<model::Image>(&geometry.shape)) move_uri(image->uri);
  };
  for (const model::Collision& each : of.root().collisions) move(each.geometry);
  for (const model::Visual& each : of.root().visuals) move(each.geometry);
  for (const model::Include& each : of.root().includes) move_uri(each.uri);
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

}  // namespace rigor::author
