// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a model file names a mesh: the URI of a file under a new name in the form its author chose,
// and the one that fits a mesh new to the model.
//
//   renamed_uri(resolver, "model://arm/meshes/a.stl", "arm/model.sdf", "arm/meshes/a.stl",
//               "arm/meshes/a.glb");  // "model://arm/meshes/a.glb"
//
// Paths are compared as text: give the model file and the meshes all from one folder, or all
// absolute.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/model/model.h>
#include <rigor/read/resolver.h>

namespace rigor::author {

/// `uri`, which stands in `file` and leads to `from`, changed to lead to `to`, which need not exist
/// yet: only its last parts differ where that is enough. Nothing when no URI of its form leads
/// there, or when another file comes first.
std::optional<std::string> renamed_uri(const read::Resolver& resolver, const std::string& uri,
                                       const std::string& file, const std::string& from,
                                       const std::string& to);

/// A file to copy, so that a model holds all that it names.
struct MeshCopy {
  std::string from;
  std::string to;
};

struct NewUri {
  std::string uri;
  std::optional<MeshCopy> copy;
};

/// `model://NAME/…` for a mesh in the folder of an SDF file's model (the one with a
/// `model.config`), `package://NAME/…` for one in a URDF file's package; one from elsewhere is to
/// be copied to that folder's `meshes`. Else, and where such a URI would find another file, the
/// path seen from `file`.
NewUri new_uri(const read::Resolver& resolver, model::Format format, const std::string& file,
               const std::string& mesh);

}  // namespace rigor::author
