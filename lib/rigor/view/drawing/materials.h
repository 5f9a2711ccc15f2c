// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a visual looks. What its model says of it goes first, in Gazebo's way: in SDF `<diffuse>`, else a
// material of Gazebo's script or of the model's own, else `<ambient>`; the texture of `<pbr>` on top,
// `<transparency>` over all. Where the model says nothing, each part of a mesh looks as its own file says.
//
// In a URDF a mesh keeps the materials of its own file (Collada, OBJ, glTF) as in RViz, and a visual's color
// is for all else; a name represents the first material of that name, those of the robot before those of its
// visuals, as urdfdom looks it up. Without one, the material of the link's `<gazebo>` block is taken.
//
//   Materials materials(root, elements, files);
//   body.surfaces = materials.of(visual, *body.mesh);

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/drawing/source_elements.h>

namespace rigor::view {

class Materials {
 public:
  Materials(const model::Root& root, SourceElements& elements, const Files& files)
      : root_(root), elements_(elements), files_(files) {}

  /// One for each part of the mesh, or one for all.
  std::vector<Surface> of(const model::Visual& visual, const mesh::TriangleMesh& mesh);

 private:
  using NamedSurfaces = std::map<std::pair<SourceId, std::string>, Surface>;

  bool is_urdf(const model::Visual& visual) const;
  std::optional<Surface> written(const model::Visual& visual);
  std::optional<Surface> of_sdf(xml::Element material);
  std::optional<Surface> of_urdf(const model::Visual& visual);
  std::optional<Surface> of_urdf(xml::Element material);
  std::optional<Surface> of_block(const model::Visual& visual);
  std::vector<Surface> of_parts(const model::Mesh& shape, const mesh::TriangleMesh& mesh);
  const NamedSurfaces& named();
  std::optional<Surface> of_script(xml::Element material);
  std::optional<Surface> of_own_script(xml::Element script, const std::string& name);
  void put_texture(Surface& surface, const std::string& uri, Span where);

  const model::Root& root_;
  SourceElements& elements_;
  const Files& files_;
  std::optional<NamedSurfaces> named_;
  std::optional<NamedSurfaces> blocks_;
  std::map<std::pair<SourceId, std::string>, std::optional<Surface>> scripted_;  // by URIs and name
};

}  // namespace rigor::view
