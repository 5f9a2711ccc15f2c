// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/scene.h>

#include <algorithm>
#include <utility>

#include <rigor/mesh/collada/transform.h>

namespace rigor::mesh {
namespace {

using xml::Element;

// A skin over a morph over a geometry is as long as this chain ever is; a circle ends here.
constexpr int kMaxControllers = 8;

}  // namespace

ColladaScene::ColladaScene(const ColladaIndex& index) : index_(index) {
  const xml::Document& document = index.document();
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const Element element = document.element(i);
    const std::string_view name = value(element, "name");
    if (element.name() == "node") nodes_.push_back({element, name, node_transform(element), {}});
    if (element.name() == "visual_scene") nodes_.push_back({element, name, Affine{}, {}});
  }
  for (ColladaNode& node : nodes_) node.items = items_of(node.element);
  const std::optional<Element> shown =
      document.root() ? descend(*document.root(), {"scene", "instance_visual_scene"})
                      : std::nullopt;
  if (shown) root_ = number_of(index.find(value(*shown, "url"), "visual_scene"));
}

std::optional<std::uint32_t> ColladaScene::number_of(std::optional<Element> node) const {
  if (!node) return std::nullopt;
  const auto at =
      std::lower_bound(nodes_.begin(), nodes_.end(), node->index(),
                       [](const ColladaNode& a, std::uint32_t i) { return a.element.index() < i; });
  if (at == nodes_.end() || at->element != *node) return std::nullopt;
  return static_cast<std::uint32_t>(at - nodes_.begin());
}

std::vector<ColladaItem> ColladaScene::items_of(Element node) {
  std::vector<ColladaItem> items;
  for (const Element child : node.children()) {
    const std::string_view name = child.name();
    std::optional<std::uint32_t> inner;
    if (name == "node") inner = number_of(child);
    if (name == "instance_node") inner = number_of(index_.find(value(child, "url"), "node"));
    if (inner) items.push_back({ColladaItem::Kind::kNode, *inner});
    const std::optional<Element> geometry = geometry_of(child);
    if (!geometry) continue;
    items.push_back({ColladaItem::Kind::kInstance, static_cast<std::uint32_t>(instances_.size())});
    instances_.push_back({*geometry, materials_of(child)});
  }
  return items;
}

std::optional<Element> ColladaScene::geometry_of(Element instance) const {
  const bool direct = instance.name() == "instance_geometry";
  if (!direct && instance.name() != "instance_controller") return std::nullopt;
  std::string_view url = value(instance, "url");
  for (int i = 0; i < kMaxControllers; ++i) {
    if (const auto geometry = index_.find(url, "geometry")) return geometry;
    const std::optional<Element> controller = index_.find(url, "controller");
    if (!controller) break;
    const std::optional<Element> skin = controller->child("skin");
    const std::optional<Element> morph = controller->child("morph");
    if (!skin && !morph) break;
    url = value(skin ? *skin : *morph, "source");
  }
  return std::nullopt;
}

std::map<std::string_view, Element> ColladaScene::materials_of(Element instance) const {
  std::map<std::string_view, Element> materials;
  const auto bound = descend(instance, {"bind_material", "technique_common"});
  if (!bound) return materials;
  for (const Element child : bound->children()) {
    const auto material = index_.find(value(child, "target"), "material");
    if (material) materials.try_emplace(value(child, "symbol"), *material);
  }
  return materials;
}

}  // namespace rigor::mesh
