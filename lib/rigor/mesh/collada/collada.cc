// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/collada.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/mesh/affine.h>
#include <rigor/mesh/collada/bake.h>
#include <rigor/mesh/collada/geometry.h>
#include <rigor/mesh/collada/index.h>
#include <rigor/mesh/collada/scene.h>
#include <rigor/xml/document.h>

namespace rigor::mesh {
namespace {

/// Metres that a unit is: 1 when nothing is said.
std::optional<double> unit_of(xml::Element root) {
  const std::optional<xml::Element> unit = descend(root, {"asset", "unit"});
  const auto meter = unit ? unit->attribute("meter") : std::nullopt;
  if (!meter) return 1;
  const std::string_view text = value(*unit, "meter");
  double meters = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), meters);
  const bool good = error == std::errc() && end == text.data() + text.size();
  if (!good || !std::isfinite(meters) || meters <= 0) return std::nullopt;
  return meters;
}

class ColladaReader {
 public:
  explicit ColladaReader(const xml::Document& document) : index_(document), scene_(index_) {}

  LoadedMesh run() {
    const xml::Element root = *index_.document().root();
    const std::optional<double> unit = unit_of(root);
    if (!unit) {
      fail(FaultKind::kMalformed, "the unit is no positive number of meters", root);
    } else if (!scene_.root()) {
      fail(FaultKind::kMalformed, "there is no scene", root);
    } else {
      walk({{*unit, 0, 0}, {0, *unit, 0}, {0, 0, *unit}, {}});
    }
    if (loaded_.usable()) bake();
    return std::move(loaded_);
  }

 private:
  // ---- Placing

  struct Visit {
    std::uint32_t node;
    std::optional<Affine> X_WN;
    std::string_view name = {};  ///< its own, else that of the node around it, as Gazebo has it
    std::size_t next = 0;        ///< item
  };

  /// Counts before anything is allocated. Depth first, without recursion: instances of nodes make
  /// the depth whatever the file wants.
  void walk(const Affine& unit) {
    std::vector<char> inside(scene_.nodes().size(), 0);
    std::vector<Visit> path{{*scene_.root(), unit}};
    inside[*scene_.root()] = 1;
    while (!path.empty() && loaded_.usable()) {
      Visit& visit = path.back();
      const ColladaNode& node = scene_.nodes()[visit.node];
      if (visit.next == node.items.size()) {
        inside[visit.node] = 0;
        path.pop_back();
        continue;
      }
      const ColladaItem item = node.items[visit.next++];
      if (++visits_ > kMaxColladaVisits) {
        fail(FaultKind::kTooLarge, "over a million nodes", node.element);
      } else if (item.kind == ColladaItem::Kind::kInstance) {
        place(visit, item.index);
      } else if (inside[item.index] != 0) {
        fail(FaultKind::kMalformed, "a node holds itself", node.element);
      } else {
        inside[item.index] = 1;
        const std::optional<Affine>& X_PN = scene_.nodes()[item.index].X_PN;
        const std::string_view own = scene_.nodes()[item.index].name;
        path.push_back({item.index,
                        visit.X_WN && X_PN ? std::optional(*visit.X_WN * *X_PN) : std::nullopt,
                        own.empty() ? visit.name : own});
      }
    }
  }

  void place(const Visit& visit, std::uint32_t instance) {
    const ColladaGeometry& shape = shape_of(scene_.instances()[instance]);
    if (!loaded_.usable()) return;
    passed_over_ += shape.passed_over;
    if (shape.triangles == 0) return;
    const xml::Element node = scene_.nodes()[visit.node].element;
    if (!visit.X_WN) return fail(FaultKind::kMalformed, "a transform is not understood", node);
    triangles_ += shape.triangles;
    vertices_ += shape.values[kColladaPosition].size() / 3;
    parts_ += shape.groups.size();
    for (std::size_t kind = 0; kind < kColladaKinds; ++kind) {
      if (!shape.values[kind].empty()) carried_[kind] = 1;
    }
    const auto lists = std::accumulate(carried_.begin(), carried_.end(), std::uint64_t{0});
    if (std::max(triangles_ * lists, vertices_) > kMaxTriangles) {
      return fail(FaultKind::kTooLarge, "over 50 million triangles", node);
    }
    if (parts_ > kMaxColladaVisits) return fail(FaultKind::kTooLarge, "over a million parts", node);
    placements_.push_back({visit.name, &scene_.instances()[instance], &shape, *visit.X_WN});
  }

  /// Read when it is first placed; its faults count once.
  const ColladaGeometry& shape_of(const ColladaInstance& instance) {
    const std::uint32_t key = instance.geometry.index();
    const auto found = shapes_.find(key);
    if (found != shapes_.end()) return found->second;
    ColladaGeometry shape =
        read_collada_geometry(index_, instance.geometry, kMaxColladaReading - bytes_read_);
    bytes_read_ += std::min(shape.bytes_read, kMaxColladaReading - bytes_read_);
    loaded_.faults.insert(loaded_.faults.end(), shape.faults.begin(), shape.faults.end());
    return shapes_.emplace(key, std::move(shape)).first->second;
  }

  // ---- Baking

  void bake() {
    if (passed_over_ > 0) loaded_.faults.push_back({FaultKind::kNotTriangles, {}, passed_over_});
    if (placements_.empty()) loaded_.faults.push_back({FaultKind::kEmpty});
    loaded_.mesh = bake_collada(index_, placements_);
    std::uint64_t bad = 0;
    for (const Vector3& p : loaded_.mesh.positions) {
      bad += !std::isfinite(p.x) + !std::isfinite(p.y) + !std::isfinite(p.z);
    }
    if (bad == 0) return;
    loaded_.mesh = {};
    loaded_.faults.push_back({FaultKind::kNotFinite, {}, bad});
  }

  void fail(FaultKind kind, const char* detail, xml::Element at) {
    loaded_.faults.push_back({kind, detail, 0, index_.line(at)});
  }

  ColladaIndex index_;
  ColladaScene scene_;
  std::map<std::uint32_t, ColladaGeometry> shapes_;  ///< by the index of the element
  std::vector<ColladaPlacement> placements_;
  std::array<std::uint64_t, kColladaKinds> carried_{};  ///< 1 for what any of them has
  std::uint64_t visits_ = 0;
  std::uint64_t triangles_ = 0;
  std::uint64_t vertices_ = 0;
  std::uint64_t parts_ = 0;
  std::uint64_t passed_over_ = 0;
  std::uint64_t bytes_read_ = 0;
  LoadedMesh loaded_{.format = Format::kCollada};
};

LoadedMesh no_collada(FaultKind kind, const char* detail) {
  return {.format = Format::kCollada, .faults = {{kind, detail}}};
}

}  // namespace

LoadedMesh read_collada(std::string_view bytes) {
  if (bytes.empty()) return no_collada(FaultKind::kEmpty, "");
  if (bytes.size() > kMaxColladaBytes) return no_collada(FaultKind::kTooLarge, "over 256 MiB");
  const xml::Document document = xml::parse(bytes, kNoSource);
  if (!document.complete() || !document.root()) {
    return no_collada(FaultKind::kMalformed, "it is no well-formed XML");
  }
  if (document.root()->name() != "COLLADA") {
    return no_collada(FaultKind::kMalformed, "it is no Collada file");
  }
  return ColladaReader(document).run();
}

}  // namespace rigor::mesh
