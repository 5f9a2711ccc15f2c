// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The edits of a model file that go with a change of its mesh files: a mesh turned, scaled or moved
// in its own file gets the scale and pose that leave everything in its place.
//
//   ModelEdits change = apply_mesh(environment, sources, loaded,
//                                  {{"arm/hull.stl", "arm/hull.glb", by, result.translation}});
//   if (change.left.empty()) write(apply_edits(bytes, change.edits)); else explain(change.left);
//
// A vertex v of the old file became v' = P D v + t: D the factors of unit and scale, P the turn of the
// up axis, t the translation. With scale s and pose X in the link it stood at X (s v), so that
//
//   s' = P (s/D), axis by axis, and X' = X P⁻¹ · translation(-s' t)
//
// put it there again. X is changed on its right side: what it is relative to does not matter.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/transform.h>
#include <rigor/model/model.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::author {

struct MeshReplacement {
  std::string file;      ///< as the model's URI resolves
  std::string new_file;  ///< the same, or another name
  mesh::Transform transform;
  mesh::Vector3 translation;  ///< of the centering: `Transformed::translation`
};

/// Why a use of the mesh keeps naming the old file, as it was placed.
enum class NotEdited : std::uint8_t {
  kIncluded,       ///< it is in an included file
  kElsewhere,      ///< it is no shape of a collision or visual: a second mesh, or a plugin's
  kSubmeshCenter,  ///< the consumer itself centers a part of the mesh
  kSubmeshForgot,  ///< it names a part, and the new format keeps no parts
  kScale,          ///< its scale cannot be read, or the new one is no number
  kPose,           ///< its pose cannot be read
  kUri,            ///< no URI of its form leads to the new file
  kCutDocument,    ///< the file is damaged
};

/// "it is in an included file".
std::string_view words(NotEdited why);

struct LeftUse {
  Span where;           ///< of the URI
  std::string subject;  ///< "arm/link base/visual hull"; empty for kElsewhere
  NotEdited why{};
};

struct ModelEdits {
  std::string path;
  std::size_t uses = 0;  ///< shapes of the file itself that use a replaced mesh
  std::vector<Edit> edits;
  /// While this is not empty, the old files have to stay as they are.
  std::vector<LeftUse> left;
};

/// `loaded` must be whole. A replacement that changes nothing gives no edits.
ModelEdits apply_mesh(const Environment& environment, const Sources& sources,
                      const read::Loaded& loaded, const std::vector<MeshReplacement>& replacements);

}  // namespace rigor::author
