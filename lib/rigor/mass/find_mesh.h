// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How whoever weighs shapes gets to what a mesh encloses (mass/mesh/survey.h), without opening files.
//
//   const FindMesh find_mesh = [&](const model::Mesh& mesh) { return &surveys.find(file_of(mesh)); };

#pragma once

#include <functional>

namespace rigor::model {
struct Mesh;
}  // namespace rigor::model

namespace rigor::mass {

struct MeshSurvey;

/// The survey of the mesh that a shape names; null when its file is not found, or not to be opened.
using FindMesh = std::function<const MeshSurvey*(const model::Mesh&)>;

}  // namespace rigor::mass
