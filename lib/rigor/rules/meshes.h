// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is known of meshes so far. Without one or the other, no mesh is opened for that.

#pragma once

namespace rigor {
class Turns;
}  // namespace rigor
namespace rigor::mass {
class MeshFiles;
class MeshSurveys;
}  // namespace rigor::mass

namespace rigor::rules {

struct Meshes {
  mass::MeshSurveys* surveys = nullptr;  ///< as solids
  mass::MeshFiles* files = nullptr;      ///< as files
  Turns* turns = nullptr;                ///< of those who ask for them from several threads
  /// Whether rules of the category assembly look at models with meshes.
  bool assembles = true;
};

}  // namespace rigor::rules
