// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/package/missing_part.h>
#include <rigor/rules/package/own_package.h>
#include <rigor/rules/package/tried.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_not_found {

std::vector<std::string> places_of(const read::Resolution& found) {
  std::vector<std::string> places;
  places.reserve(found.tried.size());
  for (const read::Tried& tried : found.tried) {
    std::string& place = places.emplace_back();
    place.reserve(tried.path.size() + tried.origin.size() + 3);
    place.append(tried.path).append(" (").append(tried.origin).append(")");
  }
  return places;
}

std::string help_for(const std::string& uri, const read::Resolution& found, Context& context) {
  const std::string package = package_without_file(uri, found, context);
  if (!package.empty()) return "the package lies in '" + package + "', and has no such file";
  constexpr std::string_view kFile = "file://";
  if (uri.starts_with(kFile) && is_absolute(std::string_view(uri).substr(kFile.size()))) {
    return "correct the path, or write a package:// URI: a file:// URI is looked for nowhere else";
  }
  constexpr std::string_view kModel = "model:///";
  if (uri.starts_with(kModel)) {
    return "write model://" + uri.substr(kModel.size()) +
           ": after a third slash the path is absolute";
  }
  return tried_places(places_of(found), uri, context.path());
}

/// Of a template, `file://$(find NAME)/…` without its scheme where the package is not found.
std::string shown_uri(const std::string& uri, Context& context) {
  constexpr std::string_view kFile = "file://";
  if (!uri.starts_with("file://package://")) return uri;
  std::string inner = uri.substr(kFile.size());
  return context.resolve(inner).path ? uri : inner;
}

void check(const MeshUse& use, Context& context) {
  const auto& uri = use.mesh.uri;
  if (uri.value.empty()) return;
  const read::Resolution& found = context.resolve(uri.value);
  if (found.path || found.remote || !found.other_case.empty()) return;
  const std::string named = shown_uri(uri.value, context);
  context.report({.where = uri.span,
                  .message = "the mesh '" + named + "' is not found",
                  .subject = use.subject,
                  .help = help_for(named, context.resolve(named), context),
                  .cause = missing_part(named, context.resolve(named), context),
                  .why = use.collision ? "The simulator omits the collision: nothing touches it."
                                       : "The simulator and RViz do not draw the visual."});
}

Rule rule() {
  return {
      .name = "mesh-not-found",
      .severity = Severity::kError,
      .summary = "a mesh file is not found",
      .why = "The simulator omits the shape: a visual is not drawn, a collision does not collide. "
             "The checkers (ign sdf -k, gz sdf -k, check_urdf) open no meshes.",
      .what_to_do = "Correct the path, or give the folders of the files: --model-path and "
                    "--package, rigor.toml, GZ_SIM_RESOURCE_PATH, ROS_PACKAGE_PATH. rigor resolve "
                    "URI prints the search.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_found
