// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// From a mesh as a model names it to what its triangles enclose.
//
//   mass::MeshSurveys surveys(disk);
//   mass::FindMesh find = mesh_finder(resolver, sources, surveys);

#pragma once

#include <rigor/mass/link_body.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/resolver.h>
#include <rigor/text/sources.h>

namespace rigor::rules {

/// URIs are looked up from the file they stand in. All three outlive the result.
inline mass::FindMesh mesh_finder(const read::Resolver& resolver, const Sources& sources,
                                  mass::MeshSurveys& surveys) {
  return [&resolver, &sources, &surveys](const model::Mesh& mesh) -> const mass::MeshSurvey* {
    if (mesh.uri.value.empty() || mesh.uri.span.nowhere()) return nullptr;
    const auto found = resolver.resolve(mesh.uri.value, sources.path(mesh.uri.span.source));
    if (!found.path) return nullptr;
    return &surveys.find(mass::mesh_choice(*found.path, mesh));
  };
}

}  // namespace rigor::rules
