// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The triangles of what a model's `<geometry>` says, whatever kind of shape it is. Private to the room.
//
//   ShapeFinder finder(elements, files);
//   const FoundShape found = finder.find(visual.geometry);
//   if (!found.mesh) say(found.why);

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/model/geometry.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/drawing/shapes.h>
#include <rigor/view/drawing/source_elements.h>

namespace rigor::view {

struct PlaneSize {
  double x = 1;  ///< m; SDF's default
  double y = 1;
  bool written = false;
};

struct FoundShape {
  std::shared_ptr<const mesh::TriangleMesh> mesh;  ///< null when there is none
  model::Vector3 scale{1, 1, 1};
  model::Pose offset;              ///< of the mesh in the frame of the shape
  std::optional<PlaneSize> plane;  ///< of a plane, which is not scaled yet
  std::string why;                 ///< there is none
};

class ShapeFinder {
 public:
  ShapeFinder(SourceElements& elements, const Files& files) : elements_(elements), files_(files) {}

  FoundShape find(const model::Geometry& geometry);

  /// Of side one.
  std::shared_ptr<const mesh::TriangleMesh> unit_box();

 private:
  FoundShape plane(const model::Geometry& geometry, const model::Plane& plane);
  FoundShape file(const model::Mesh& mesh) const;
  FoundShape terrain(const model::Geometry& geometry, const model::Heightmap& heightmap);
  FoundShape outlines(const model::Geometry& geometry, const model::Polyline& polyline);

  SourceElements& elements_;
  const Files& files_;
  ShapeMeshes meshes_;
  using Key = std::pair<std::string, std::vector<double>>;
  FoundShape made(Key key, const std::function<std::shared_ptr<const mesh::TriangleMesh>()>& make,
                  std::string why);

  std::map<Key, std::shared_ptr<const mesh::TriangleMesh>> made_;  // terrains and outlines
  std::size_t made_triangles_ = 0;
};

}  // namespace rigor::view
