// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a scene is made from, for a file that was loaded: where all is, the file's elements, its meshes
// and the pictures of its heightmaps, each read once.
//
//   const SceneFiles files(loaded, workspace, environment.resolver, environment.workers);
//   SceneResult made = build_scene(files.input(), {});

#pragma once

#include <map>
#include <memory>
#include <string>

#include <rigor/mass/mesh/survey.h>
#include <rigor/mesh/read.h>
#include <rigor/model/frames.h>
#include <rigor/process/workers.h>
#include <rigor/read/documents.h>
#include <rigor/read/load.h>
#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/simulate/scene/build.h>
#include <rigor/simulate/scene/start.h>

namespace rigor::simulate {

class SceneFiles {
 public:
  /// Joints stand at `positions` when a run begins, others as `start_within_limits` says. The other
  /// arguments outlive this.
  SceneFiles(const read::Loaded& loaded, read::Workspace& workspace, const read::Resolver& resolver,
             const process::Workers& workers, const model::JointPositions& positions = {});
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  /// Meshes are read when they are asked for. Not for several threads at a time.
  const SceneInput& input() const { return input_; }

 private:
  std::string path_of(const model::Field<std::string>& uri) const;
  LoadedHeights heights_at(const std::string& path, const std::string& uri) const;

  read::Workspace& workspace_;
  const read::Resolver& resolver_;
  const process::Workers& workers_;
  Start start_;
  model::Frames frames_;
  read::Documents documents_;
  mass::MeshSurveys surveys_;
  std::map<std::string, std::unique_ptr<mesh::LoadedMesh>> meshes_;
  std::map<std::string, LoadedHeights> heights_;
  SceneInput input_;
};

}  // namespace rigor::simulate
