// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <rigor/rules/package/own_package.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>

namespace rigor::rules::mesh_uri_not_for_ros {

bool is_url(std::string_view uri) {
  for (const std::string_view scheme : {"package://", "file://", "http://", "https://"}) {
    if (uri.starts_with(scheme)) return true;
  }
  return false;
}

std::optional<Fix> by_package(const model::Mesh& mesh, const std::string& path,
                              const std::optional<RosPackage>& package) {
  if (!package) return std::nullopt;
  const std::string inside = relative_path(package->folder, path);
  if (inside.starts_with("..") || is_absolute(inside)) return std::nullopt;
  const std::string uri = "package://" + package->name + "/" + inside;
  return Fix{"write " + uri, Applicability::kUnsafe, {{mesh.uri.span, xml::escaped(uri)}}};
}

template <class Shapes>
void check_shapes(const Shapes& shapes, Context& context) {
  std::optional<RosPackage> package;
  bool looked = false;
  for (const auto& shape : shapes) {
    const auto* mesh = std::get_if<model::Mesh>(&shape.geometry.shape);
    if (mesh == nullptr || mesh->uri.value.empty()) continue;
    const std::string& uri = mesh->uri.value;
    const auto& path = context.resolve(uri).path;
    if (!path) continue;  // mesh-not-found tells it
    if (is_url(uri)) {
      if (uri.starts_with("http") || uri.find(' ') == std::string::npos) continue;
      context.report({.where = mesh->uri.span,
                      .message = "'" + uri + "' has a space: RViz finds no mesh by it",
                      .subject = context.subject(shape)});
      continue;
    }
    if (!looked) package = own_package(context);
    looked = true;
    context.report({.where = mesh->uri.span,
                    .message = "'" + uri + "' is no URL: RViz and MoveIt find no mesh by it",
                    .subject = context.subject(shape),
                    .fix = by_package(*mesh, *path, package)});
  }
}

void check(const model::Root& root, Context& context) {
  check_shapes(root.visuals, context);
  check_shapes(root.collisions, context);
}

Rule rule() {
  return {
      .name = "mesh-uri-not-for-ros",
      .severity = Severity::kError,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .targets = {Target::kRos},
      .summary = "a mesh is named by a path that ROS does not find",
      .why = "A robot description is a text on a topic, and no longer knows which file it came "
             "from. So RViz and MoveIt load meshes by resource_retriever, which takes package://, "
             "file:// and http:// URLs: a relative path or model:// leads nowhere. It loads by "
             "curl, and curl from 7.78 refuses a space.",
      .what_to_do = "Write package://NAME/PATH, with the name from the package.xml.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_uri_not_for_ros
