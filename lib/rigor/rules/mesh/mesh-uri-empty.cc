// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_uri_empty {

/// What libsdformat writes in place of a URI that was not set.
constexpr const char* kUnset = "__default__";

void check(const MeshUse& use, Context& context) {
  const auto& uri = use.mesh.uri;
  const bool unset = uri.value.empty() || uri.value == kUnset;
  if (!uri.written || !unset) return;
  context.report({.where = uri.span.size() > 0 ? uri.span : use.geometry.site.name,
                  .message = uri.value.empty() ? "the mesh names no file: its URI is empty"
                                               : "the mesh names no file: its URI is '__default__'",
                  .subject = use.subject});
}

Rule rule() {
  return {
      .name = "mesh-uri-empty",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "a mesh names no file",
      .why = "The simulator finds no file and omits the shape: a visual is not drawn, a collision "
             "does not collide. `__default__` is what libsdformat writes where no URI was set.",
      .what_to_do = "Name the mesh file, or remove the visual or collision.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_uri_empty
