// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// New meshes beside the one that they stand in for, with URIs of its form.
//
//   MeshFiles files(edited);
//   const auto uri = files.add({path, uri}, "hull", mesh);   // "package://arm/meshes/upper_hull.stl"
//   if (uri) bytes = files.of(*uri).bytes;
//
// Private to the room.

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/author/verbs/change.h>
#include <rigor/author/verbs/edited_model.h>
#include <rigor/mesh/triangle_mesh.h>

namespace rigor::author {

class MeshFiles {
 public:
  explicit MeshFiles(const EditedModel& edited) : edited_(edited) {}

  struct OldMesh {
    std::string path;
    std::string uri;  ///< that leads there from the model's file
  };

  /// `upper_hull.stl` for `upper.dae`; with a number where that is another file. Nothing when no URI of the old one's
  /// form leads there.
  std::optional<std::string> add(const OldMesh& old, std::string_view suffix,
                                 mesh::TriangleMesh mesh);

  const NewFile& of(const std::string& uri) const { return files_.at(uri); }
  /// Null of a URI that is none of them.
  std::shared_ptr<const mesh::TriangleMesh> surface(const std::string& uri) const;

 private:
  std::string free_path(const std::string& folder, const std::string& name,
                        const std::string& bytes);

  const EditedModel& edited_;
  std::map<std::string, NewFile> files_;                                     // by URI
  std::map<std::string, std::shared_ptr<const mesh::TriangleMesh>> meshes_;  // by URI
  std::map<std::string, std::string> taken_;  // bytes by path; empty ones are others'
};

}  // namespace rigor::author
