// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_uri_empty {

void check(const MeshUse& use, Context& context) {
  const auto& uri = use.mesh.uri;
  if (!uri.written || !uri.value.empty()) return;
  context.report({.where = uri.span.size() > 0 ? uri.span : use.geometry.site.name,
                  .message = "mesh names no file: its uri is empty",
                  .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-uri-empty",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "a mesh names no file",
      .why = "The simulator looks for a file without a name, finds none, and leaves the shape out: "
             "a visual cannot be seen, a collision is passed through.",
      .what_to_do = "Name the mesh file, or take the visual or collision out.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_uri_empty
