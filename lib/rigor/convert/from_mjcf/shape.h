// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Geoms as shapes of the target. Meshes stay the files that they are where the target reads them; others, and
// vertices that the MJCF holds itself, are written beside the result. Private to the room.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/convert/from_mjcf/plan.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/urdf/draft.h>

namespace rigor::convert {

struct MjcfShape {
  UrdfGeometry geometry;
  std::optional<SdfElement> other = {};  ///< a shape that only SDF has, in place of the geometry
  model::Pose X_GS = {};                 ///< in the geom's frame
  std::string suffix = {};               ///< of its name
};

enum class MjcfUse : std::uint8_t { kVisual, kCollision };

class MjcfShaper {
 public:
  /// `urdf` in a conversion to URDF, `sdf` in one to SDF: for their URIs and files.
  MjcfShaper(const MjcfPlan& plan, Ledger& ledger, UrdfDraft* urdf, SdfDraft* sdf)
      : plan_(plan), ledger_(ledger), urdf_(urdf), sdf_(sdf) {}

  /// Nothing, with a note, where the target has no such shape.
  std::vector<MjcfShape> shapes(const model::Geometry& geometry, const std::string& subject,
                                MjcfUse use);

  std::vector<SideFile> files() && { return std::move(files_); }

 private:
  friend struct MjcfShapeMaker;

  bool writes() const { return plan_.options.files == FromMjcfFiles::kWritten; }
  std::string uri_of(const model::Field<std::string>& uri, const std::string& subject) const;
  std::optional<std::string> mesh_file(const model::Mesh& mesh, const model::Geometry& geometry);
  std::string put(const std::string& identity, const std::string& stem, std::string bytes);

  const MjcfPlan& plan_;
  Ledger& ledger_;
  UrdfDraft* urdf_;
  SdfDraft* sdf_;
  std::vector<SideFile> files_;
  std::map<std::string, std::string> names_;  // of files, by what they hold
};

}  // namespace rigor::convert
