// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include <rigor/rules/package/own_package.h>
#include <rigor/rules/package/tried.h>
#include <rigor/rules/rule.h>

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

void check(const MeshUse& use, Context& context) {
  const auto& uri = use.mesh.uri;
  if (uri.value.empty()) return;
  const read::Resolution& found = context.resolve(uri.value);
  if (found.path || found.remote || !found.other_case.empty()) return;
  const std::string package = package_without_file(uri.value, found, context);
  context.report({.where = uri.span,
                  .message = "the mesh '" + uri.value + "' is not found",
                  .subject = use.subject,
                  .help = package.empty()
                              ? tried_places(places_of(found), uri.value)
                              : "the package lies in '" + package + "', and has no such file"});
}

Rule rule() {
  return {
      .name = "mesh-not-found",
      .severity = Severity::kError,
      .summary = "a mesh file is not found",
      .why = "The simulator leaves the shape out: a visual cannot be seen, a collision is passed "
             "through. Neither ign sdf -k nor check_urdf looks.",
      .what_to_do =
          "Mend the path, or say where the files are: --model-path and --package, rigor.toml, "
          "GZ_SIM_RESOURCE_PATH, ROS_PACKAGE_PATH. rigor resolve URI prints the search.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_not_found
