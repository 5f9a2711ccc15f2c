// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The mirror image of a part of a robot: a right leg from a left one.
//
//   const Change change = mirrored(*edited, "left_hip", {.plane = MirrorPlane::kXz, .from = "left", .to = "right"});
//
// The plane is that of the frame of the link that carries the part; of a root, its own. Each frame of the part becomes its
// image S X S, where S is the reflection; so a joint turns about -S a, and the same position bends the image as it bends
// the original; limits and mimics stay. Tensors become S I S, meshes get a negative scale, which turns the winding of their
// triangles over.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/author/verbs/change.h>

namespace rigor::author {

enum class MirrorPlane : std::uint8_t { kYz, kXz, kXy };  ///< by their normals: x, y, z

struct MirrorRequest {
  MirrorPlane plane = MirrorPlane::kXz;
  /// With these, the image is a copy beside the original: in each name of the part `from` becomes `to`. Without, the part
  /// itself is mirrored.
  std::string from, to;
};

/// Refused: shapes that are not their own image and cannot be scaled to it, screws, parts in files that are included.
Change mirrored(const EditedModel& edited, std::string_view link, const MirrorRequest& request);

}  // namespace rigor::author
