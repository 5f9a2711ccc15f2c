// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The nodes of a Collada file as a graph: which nodes and geometries each one holds, directly or by
// instances. Written once a node, however often it is instanced.
//
//   const ColladaScene scene(index);
//   if (scene.root()) walk(scene.nodes()[*scene.root()]);

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/affine.h>
#include <rigor/mesh/collada/index.h>

namespace rigor::mesh {

/// A geometry, directly or behind a controller (whose bones are not applied: it stands as modeled).
struct ColladaInstance {
  xml::Element geometry;
  std::map<std::string_view, xml::Element> materials;  ///< by symbol
};

/// A child, in the order of the file.
struct ColladaItem {
  enum class Kind : std::uint8_t { kNode, kInstance } kind;
  std::uint32_t index;
};

struct ColladaNode {
  xml::Element element;
  std::string_view name;
  std::optional<Affine> X_PN;  ///< against its parent; nothing when it is not understood
  std::vector<ColladaItem> items;
};

class ColladaScene {
 public:
  explicit ColladaScene(const ColladaIndex& index);

  /// Every <node> of the file, and every <visual_scene> as one, in the order of the file.
  const std::vector<ColladaNode>& nodes() const { return nodes_; }
  const std::vector<ColladaInstance>& instances() const { return instances_; }

  /// The node that is the scene; nothing when the file shows none.
  std::optional<std::uint32_t> root() const { return root_; }

 private:
  std::optional<std::uint32_t> number_of(std::optional<xml::Element> node) const;
  std::vector<ColladaItem> items_of(xml::Element node);
  std::optional<xml::Element> geometry_of(xml::Element instance) const;
  std::map<std::string_view, xml::Element> materials_of(xml::Element instance) const;

  const ColladaIndex& index_;
  std::vector<ColladaNode> nodes_;
  std::vector<ColladaInstance> instances_;
  std::optional<std::uint32_t> root_;
};

}  // namespace rigor::mesh
