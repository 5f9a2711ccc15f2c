// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include <rigor/mesh/asset/readers.h>
#include <rigor/mesh/collada/collada.h>
#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/collada/scene.h>
#include <rigor/xml/document.h>

namespace rigor::mesh {
namespace {

using xml::Element;

// What a transform may be off its ideal: exporters print six digits of each number of a matrix.
constexpr double kPrinted = 1e-4;

std::string copied(std::string_view text) { return std::string(text.substr(0, kMaxCopiedText)); }

std::optional<double> parsed_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool is_sheared(const Affine& a) {
  const auto square = [](const Vector3& u, const Vector3& v) {
    return std::abs(dot(u, v)) <= kPrinted * length(u) * length(v);
  };
  return !square(a.x, a.y) || !square(a.y, a.z) || !square(a.z, a.x);
}

bool is_uneven(const Affine& a) {
  const auto [least, most] = std::minmax({length(a.x), length(a.y), length(a.z)});
  return most - least > kPrinted * most;
}

bool has_triangles(Element group) {
  const std::string_view kind = group.name();
  return kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "trifans" ||
         kind == "tristrips";
}

class ColladaAssetReader {
 public:
  ColladaAssetReader(const xml::Document& document, const Disk& disk, const std::string& path)
      : index_(document), disk_(disk), path_(path) {}

  Asset run() {
    const Element root = *index_.document().root();
    facts_.version = copied(value(root, "version"));
    if (const auto asset = root.child("asset")) about(*asset);
    for (std::uint32_t i = 0; i < index_.document().element_count(); ++i) {
      element(index_.document().element(i));
    }
    const ColladaScene scene(index_);
    nodes(scene);
    repeated(scene);
    return {.collada = std::move(facts_),
            .textures = std::move(textures_),
            .undefined_materials = undefined_materials(scene)};
  }

 private:
  void about(Element asset) {
    if (const auto tool = descend(asset, {"contributor", "authoring_tool"})) {
      facts_.authoring_tool = copied(trimmed_text(*tool));
    }
    if (const auto unit = asset.child("unit")) {
      facts_.unit_line = index_.line(*unit);
      facts_.unit_name = copied(value(*unit, "name"));
      facts_.meter = parsed_number(value(*unit, "meter"));
    }
    const auto up = asset.child("up_axis");
    if (!up) return;
    using Up = ColladaFacts::Up;
    const std::string_view axis = trimmed_text(*up);
    facts_.up_axis_line = index_.line(*up);
    facts_.up_axis = axis == "X_UP"   ? Up::kX
                     : axis == "Y_UP" ? Up::kY
                     : axis == "Z_UP" ? Up::kZ
                                      : Up::kOther;
  }

  void element(Element e) {
    const std::string_view name = e.name();
    const auto see = [&](Sighting& sighting) { sighting.add(index_.line(e)); };
    if (name == "camera") see(facts_.cameras);
    if (name == "light") see(facts_.lights);
    if (name == "animation") see(facts_.animations);
    if (name == "controller") see(facts_.controllers);
    if (name == "lines" || name == "linestrips") see(facts_.lines);
    if (name == "instance_node") see(facts_.instance_nodes);
    if (name == "double_sided" && trimmed_text(e) == "1") see(facts_.double_sided);
    if (name == "instance_geometry" && !index_.find(value(e, "url"), "geometry")) {
      see(facts_.missing_geometries);
    }
    if (name == "image") image(e);
    if (name == "surface" || name == "sampler2D") image_of(e);
  }

  // ---- Textures

  /// Collada 1.4 has the path in <init_from>, 1.5 in a <ref> inside it.
  void image(Element e) {
    const auto from = e.child("init_from");
    const auto ref = from ? from->child("ref") : std::nullopt;
    if (e.child("data")) return;
    name_file(from ? trimmed_text(ref ? *ref : *from) : std::string_view(), from ? *from : e);
  }

  /// A texture that leads to no image is a reference too: to the id as it is written.
  void image_of(Element e) {
    const auto from = e.child("init_from");
    const auto instance = e.child("instance_image");
    if (!from && !instance) return;
    const std::string_view id = from ? trimmed_text(*from) : value(*instance, "url");
    if (index_.find_id(from ? id : id.substr(std::min<std::size_t>(1, id.size())), "image")) return;
    if (textures_.size() == kMaxReferences) return;
    textures_.push_back({.written = copied(id), .line = index_.line(from ? *from : *instance)});
  }

  void name_file(std::string_view written, Element at) {
    if (textures_.size() == kMaxReferences) return;
    textures_.push_back(resolve(disk_, path_, written, index_.line(at)));
  }

  // ---- Nodes

  void nodes(const ColladaScene& scene) {
    const std::vector<char> shaped = with_shapes(scene);
    for (std::size_t i = 0; i < shaped.size(); ++i) {
      if (shaped[i] == 0) continue;
      const ColladaNode& node = scene.nodes()[i];
      const auto see = [&](Sighting& sighting) { sighting.add(index_.line(node.element)); };
      if (!node.X_PN) {
        see(facts_.unclear_nodes);
        continue;
      }
      if (determinant(*node.X_PN) < 0) see(facts_.mirrored_nodes);
      if (is_sheared(*node.X_PN)) see(facts_.sheared_nodes);
      if (is_uneven(*node.X_PN)) see(facts_.unevenly_scaled_nodes);
    }
  }

  /// Which nodes hold a geometry, or a node that does; a node that is instanced out of their order is
  /// taken to hold one. Nodes inside a node come behind it.
  static std::vector<char> with_shapes(const ColladaScene& scene) {
    std::vector<char> shaped(scene.nodes().size(), 0);
    for (std::size_t i = shaped.size(); i-- > 0;) {
      for (const ColladaItem& item : scene.nodes()[i].items) {
        const bool unknown = item.kind == ColladaItem::Kind::kInstance || item.index <= i;
        if (unknown || shaped[item.index] != 0) shaped[i] = 1;
      }
    }
    return shaped;
  }

  void repeated(const ColladaScene& scene) {
    std::map<std::uint32_t, int> uses;
    for (const ColladaInstance& instance : scene.instances()) {
      if (++uses[instance.geometry.index()] == 2) {
        facts_.repeated_geometries.add(index_.line(instance.geometry));
      }
    }
  }

  // ---- Materials

  /// Triangles have a symbol, which an instance of their geometry binds to a material. Readers keep
  /// what any instance bound, and take what is bound by none for a material's id.
  std::vector<Mention> undefined_materials(const ColladaScene& scene) const {
    std::set<std::string_view> known;
    std::set<std::uint32_t> geometries;
    for (const ColladaInstance& instance : scene.instances()) {
      geometries.insert(instance.geometry.index());
      for (const auto& [symbol, material] : instance.materials) known.insert(symbol);
    }
    std::vector<Mention> undefined;
    for (const std::uint32_t geometry : geometries) {
      const auto mesh = index_.document().element(geometry).child("mesh");
      if (!mesh) continue;
      for (const Element group : mesh->children()) {
        const std::string_view symbol = value(group, "material");
        if (symbol.empty() || !has_triangles(group) || !known.insert(symbol).second ||
            index_.find_id(symbol, "material") || undefined.size() == kMaxReferences) {
          continue;
        }
        undefined.push_back({copied(symbol), index_.line(group)});
      }
    }
    return undefined;
  }

  ColladaIndex index_;
  const Disk& disk_;
  const std::string& path_;
  ColladaFacts facts_;
  std::vector<FileReference> textures_;
};

}  // namespace

Asset collada_asset(const Disk& disk, const std::string& path, std::string_view bytes) {
  if (bytes.size() > kMaxColladaBytes) return {.problem = "over 256 MiB"};
  const xml::Document document = xml::parse(bytes, kNoSource);
  if (!document.root()) return {.problem = "it has no elements"};
  Asset asset = ColladaAssetReader(document, disk, path).run();
  if (!document.complete()) asset.problem = "it is no well-formed XML";
  return asset;
}

}  // namespace rigor::mesh
