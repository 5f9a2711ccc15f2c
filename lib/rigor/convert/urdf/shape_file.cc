// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/shape_file.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/urdf/uri.h>
#include <rigor/mass/polyline.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/repair/cap.h>
#include <rigor/mesh/select.h>
#include <rigor/mesh/write/write.h>
#include <rigor/schema/value.h>
#include <rigor/text/path.h>
#include <rigor/write/safe_name.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

bool is_size(double number) { return std::isfinite(number) && number > 0; }

std::string size_words(std::initializer_list<double> sizes) {
  std::string words;
  for (const double size : sizes) words += (words.empty() ? "" : "x") + schema::to_shortest(size);
  std::erase(words, '+');
  return words;
}

TriangleMesh ellipsoid_mesh(const Vector3& radii) {
  TriangleMesh ball = mesh::mesh_of(mesh::Sphere{1});
  for (Vector3& p : ball.positions) p = {radii.x * p.x, radii.y * p.y, radii.z * p.z};
  return ball;
}

/// Twice the area that an outline goes round, m²; negative when it goes clockwise.
double doubled_area(const mass::Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector3& a = outline[i];
    const Vector3& b = outline[(i + 1) % outline.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum;
}

/// Nothing when the outline is none.
std::optional<TriangleMesh> prism_mesh(const model::Polyline& polyline) {
  if (!mass::solid_of(polyline)) return std::nullopt;
  mass::Outline outline;
  for (const auto& point : polyline.points) {
    if (outline.empty() || point.value != outline.back()) outline.push_back(point.value);
  }
  if (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  if (doubled_area(outline) < 0) std::reverse(outline.begin(), outline.end());

  TriangleMesh prism;
  const auto n = static_cast<std::uint32_t>(outline.size());
  std::vector<mesh::DirectedEdge> edges;
  for (const Vector3& p : outline) prism.positions.push_back({p.x, p.y, 0});
  for (const Vector3& p : outline) prism.positions.push_back({p.x, p.y, polyline.height.value});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    edges.push_back({i, next});
    prism.triangles.push_back({i, next, n + next});
    prism.triangles.push_back({i, n + next, n + i});
  }
  for (const auto& [a, b, c] : mesh::cap_of(edges, prism.positions, {0, 0, 1})) {
    prism.triangles.push_back({n + a, n + b, n + c});
    prism.triangles.push_back({a, c, b});
  }
  return prism;
}

/// Nothing when the file has no such part.
std::optional<TriangleMesh> part_mesh(const Source& source, const std::string& path,
                                      const model::Mesh& shape) {
  mesh::LoadedMesh loaded = mesh::read_mesh(source.resolver.disk(), path, source.workers);
  if (!loaded.usable()) return std::nullopt;
  std::vector<std::uint32_t> faces;
  for (const mesh::Part& part : loaded.mesh.parts) {
    if (part.name != shape.submesh.value) continue;
    for (std::size_t i = 0; i < part.count; ++i) {
      faces.push_back(static_cast<std::uint32_t>(part.first + i));
    }
  }
  if (faces.empty()) return std::nullopt;
  TriangleMesh part = mesh::selected(std::move(loaded.mesh), faces);
  for (mesh::Material& material : part.materials) material.texture.clear();
  if (!shape.center.value) return part;
  const mesh::Bounds bounds = mesh::bounds_of(mesh::used_positions(part));
  const Vector3 middle = 0.5 * (bounds.min + bounds.max);
  for (Vector3& p : part.positions) p = p - middle;
  return part;
}

class ShapeFiler {
 public:
  ShapeFiler(UrdfDraft& draft, const model::Geometry& geometry)
      : draft_(draft), geometry_(geometry) {}

  template <class Shape>
  std::optional<std::string> operator()(const Shape& /*shape*/) const {
    return std::nullopt;
  }
  std::optional<std::string> operator()(const model::Ellipsoid& shape) const {
    const auto& [x, y, z] = shape.radii.value;
    if (!is_size(x) || !is_size(y) || !is_size(z)) return std::nullopt;
    const std::string stem = "ellipsoid-" + size_words({x, y, z});
    return file(stem, stem, ".stl", [&shape] { return ellipsoid_mesh(shape.radii.value); });
  }
  std::optional<std::string> operator()(const model::Cone& shape) const {
    const double radius = shape.radius.value;
    const double length = shape.length.value;
    if (!is_size(radius) || !is_size(length)) return std::nullopt;
    const std::string stem = "cone-" + size_words({radius, length});
    return file(stem, stem, ".stl", [=] { return mesh::cone_mesh(radius, length); });
  }
  std::optional<std::string> operator()(const model::Polyline& shape) const {
    if (outlines() != 1) return std::nullopt;
    std::string identity = "prism " + size_words({shape.height.value});
    for (const auto& point : shape.points) {
      identity += ' ' + size_words({point.value.x, point.value.y});
    }
    const std::string stem = "prism-" + std::to_string(draft_.files.size() + 1);
    return file(identity, stem, ".stl", [&shape] { return prism_mesh(shape); });
  }
  std::optional<std::string> operator()(const model::Mesh& shape) const {
    const auto path = file_of(draft_.source, shape.uri);
    if (shape.submesh.value.empty() || !path) return std::nullopt;
    const std::string_view name = file_name(*path);
    std::string stem = write::safe_name(name.substr(0, name.rfind('.')));
    stem += '-' + write::safe_name(shape.submesh.value) + (shape.center.value ? "-centered" : "");
    const std::string identity = stem + ' ' + *path + ' ' + shape.submesh.value;
    return file(identity, stem, ".dae", [&] { return part_mesh(draft_.source, *path, shape); });
  }

 private:
  /// A polyline with holes is several in one geometry, of which the model keeps the first.
  std::size_t outlines() const {
    const auto parent = draft_.source.documents.element(geometry_.site).parent();
    std::size_t count = 0;
    for (const xml::Element child : parent->children()) {
      if (child.name() == "polyline") ++count;
    }
    return count;
  }

  /// `identity` tells meshes apart that have the same stem.
  template <class MakeMesh>
  std::optional<std::string> file(const std::string& identity, const std::string& stem,
                                  std::string_view ending, const MakeMesh& make_mesh) const {
    if (const auto known = draft_.file_names.find(identity); known != draft_.file_names.end()) {
      return known->second;
    }
    const std::optional<TriangleMesh> shape = make_mesh();
    if (!shape) return std::nullopt;
    std::string name = stem + std::string(ending);
    auto written = mesh::write_mesh(*shape, name);
    if (!written.bytes) return std::nullopt;
    // A further mesh of the stem gets a number.
    const auto is_taken = [&](const SideFile& other) { return other.name == name; };
    for (int n = 2; std::any_of(draft_.files.begin(), draft_.files.end(), is_taken); ++n) {
      name = stem + '-' + std::to_string(n) + std::string(ending);
    }
    draft_.files.push_back({name, *std::move(written.bytes)});
    draft_.file_names.emplace(identity, name);
    return name;
  }

  UrdfDraft& draft_;
  const model::Geometry& geometry_;
};

}  // namespace

std::optional<std::string> shape_file(UrdfDraft& draft, const model::Geometry& geometry) {
  return std::visit(ShapeFiler(draft, geometry), geometry.shape);
}

}  // namespace rigor::convert
