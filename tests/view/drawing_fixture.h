// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model in memory, read and drawn.

#pragma once

#include <map>
#include <string>
#include <utility>

#include <rigor/mass/mesh/reads.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/drawing/files.h>

namespace rigor::view {

struct DrawnModel {
  DrawnModel(const std::string& path, std::map<std::string, std::string> files)
      : disk(std::move(files)),
        environment(disk, {}),
        workspace(disk, sources),
        reads(disk, environment.workers) {
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    loaded = read::load(reader, workspace.open(path));
  }

  Drawing draw(std::set<Layer> layers, const model::JointPositions& positions = {}) {
    const model::Frames frames(loaded.root, positions);
    return view::draw(loaded.root, frames, sources, files_of(environment.resolver, sources, reads),
                      {.layers = std::move(layers)});
  }

  MemoryDisk disk;
  Environment environment;
  Sources sources;
  read::Workspace workspace;
  mass::MeshReads reads;
  read::Loaded loaded;
};

/// The parts of a link "body" in an SDF model "m".
inline Drawing drawn_sdf(const std::string& parts, std::set<Layer> layers,
                         std::map<std::string, std::string> files = {}) {
  files["m.sdf"] =
      "<sdf version='1.9'><model name='m'><link name='body'>" + parts + "</link></model></sdf>";
  return DrawnModel("m.sdf", std::move(files)).draw(std::move(layers));
}

inline std::string visual_of(const std::string& shape, const std::string& more = {}) {
  return "<visual name='v'><geometry>" + shape + "</geometry>" + more + "</visual>";
}

/// Where a corner of a body's mesh is.
inline model::Vector3 place_of(const Body& body, const model::Vector3& p) {
  return transform(body.pose, {body.scale.x * p.x, body.scale.y * p.y, body.scale.z * p.z});
}

}  // namespace rigor::view
