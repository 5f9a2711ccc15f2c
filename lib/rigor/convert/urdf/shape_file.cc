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

#include <rigor/convert/urdf/outlines.h>
#include <rigor/convert/urdf/uri.h>
#include <rigor/mass/mesh/prism.h>
#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/read.h>
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

/// Why a shape has no file that could have one; empty of others.
struct NoShapeFile {
  const Source& source;
  const model::Geometry& geometry;

  template <class Shape>
  std::string operator()(const Shape& /*shape*/) const {
    return {};
  }
  std::string operator()(const model::Ellipsoid& shape) const {
    const auto& [x, y, z] = shape.radii.value;
    return is_size(x) && is_size(y) && is_size(z) ? "" : "a radius is not positive and finite";
  }
  std::string operator()(const model::Cone& shape) const {
    return is_size(shape.radius.value) && is_size(shape.length.value)
               ? ""
               : "its radius or length is not positive and finite";
  }
  std::string operator()(const model::Polyline& shape) const {
    return why_no_prism(outlines_of(source, geometry), shape.height.value);
  }
};

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
    const double height = shape.height.value;
    const std::vector<mass::Outline> outlines = outlines_of(draft_.source, geometry_);
    std::string identity = "prism " + size_words({height});
    for (const mass::Outline& outline : outlines) {
      for (const Vector3& point : outline) identity += ' ' + size_words({point.x, point.y});
      identity += " /";
    }
    const std::string stem = "prism-" + std::to_string(draft_.files.size() + 1);
    return file(identity, stem, ".stl", [&] { return mass::prism_mesh(outlines, height); });
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

std::string why_no_shape_file(const UrdfDraft& draft, const model::Geometry& geometry) {
  if (draft.options.shapes != ShapePolicy::kMesh) return {};
  return std::visit(NoShapeFile{draft.source, geometry}, geometry.shape);
}

}  // namespace rigor::convert
