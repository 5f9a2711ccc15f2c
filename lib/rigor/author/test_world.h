// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A world with one mesh alone on the ground, to look at it in a simulator: a sun, a ground plane,
// and a model that has the mesh for visual and collision. Nothing in it is included, so that
// nothing needs to be downloaded.
//
//   std::string world = test_world({"wheel", "meshes/wheel.stl", {0.001, 0.001, 0.001}}, survey);

#pragma once

#include <string>

#include <rigor/mass/mesh/survey.h>
#include <rigor/model/pose.h>

namespace rigor::author {

struct TestBody {
  std::string name;  ///< of the model
  std::string uri;   ///< of the mesh, as the world's file is to name it
  model::Vector3 scale{1, 1, 1};
  double density = 1000;  ///< kg/m³
};

/// A sheet of a millimeter is thin, and heavy enough for any solver, m.
inline constexpr double kMinSide = 1e-3;

/// An SDF file. The mesh's lowest point stands on the ground, its bounds' middle above the origin.
/// The mass is that of the mesh where it is a solid (mass/mesh/survey.h), else of its convex hull;
/// a flat mesh has that of a box around it, of kMinSide at least. The survey must be usable.
std::string test_world(const TestBody& body, const mass::MeshSurvey& survey);

}  // namespace rigor::author
