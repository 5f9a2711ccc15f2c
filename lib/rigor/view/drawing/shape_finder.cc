// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/shape_finder.h>

#include <array>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mass/mesh/prism.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/view/turn.h>

namespace rigor::view {
namespace {

using model::Vector3;

FoundShape no_shape(std::string why) {
  FoundShape found;
  found.why = std::move(why);
  return found;
}

std::shared_ptr<const mesh::TriangleMesh> drawn_prism(const std::vector<mass::Outline>& outlines,
                                                      double height) {
  auto prism = mass::prism_mesh(outlines, height);
  if (!prism) return nullptr;
  prism->parts = {{"polyline", {}, 0, prism->triangles.size()}};
  return std::make_shared<const mesh::TriangleMesh>(std::move(*prism));
}

std::optional<std::array<double, 2>> two_numbers(const std::optional<read::Text>& text) {
  if (!text) return std::nullopt;
  const auto parsed = schema::parse_vector2(text->text);
  const auto* value = std::get_if<std::array<double, 2>>(&parsed);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

/// All outlines of a geometry: the model's struct holds the first.
std::vector<mass::Outline> outlines_in(xml::Element geometry) {
  std::vector<mass::Outline> outlines;
  for (const xml::Element polyline : geometry.children()) {
    if (polyline.name() != "polyline") continue;
    mass::Outline& outline = outlines.emplace_back();
    for (const xml::Element point : polyline.children()) {
      if (point.name() != "point") continue;
      const auto p = two_numbers(read::Text{point.text(), point.text_span()});
      outline.push_back(p ? Vector3{(*p)[0], (*p)[1], 0} : Vector3());
    }
  }
  return outlines;
}

}  // namespace

FoundShape ShapeFinder::plane(const model::Geometry& geometry, const model::Plane& plane) {
  const Vector3& normal = plane.normal.value;
  const double size = length(normal);
  if (!(size > 0) || !std::isfinite(size)) return no_shape("its normal has no direction");
  FoundShape found;
  found.plane.emplace();
  if (const auto element = elements_.at(geometry.site)) {
    if (const auto sides = two_numbers(read::child_text(*element, "size"))) {
      if (!((*sides)[0] > 0) || !((*sides)[1] > 0)) {
        return no_shape("a size is not positive and finite");
      }
      found.plane = PlaneSize{(*sides)[0], (*sides)[1], true};
    }
  }
  found.offset.rotation = turn_from_z(normal);
  found.mesh = meshes_.square();
  return found;
}

FoundShape ShapeFinder::file(const model::Mesh& mesh) const {
  FoundShape found;
  found.scale = mesh.scale.value;
  if (mesh.uri.value.empty()) return no_shape("it names no mesh");
  if (!files_.mesh) return no_shape("meshes are skipped");
  found.mesh = files_.mesh(mesh, found.why);
  if (!found.mesh && found.why.empty()) found.why = mesh.uri.value + " is not found";
  return found;
}

FoundShape ShapeFinder::terrain(const model::Geometry& geometry,
                                const model::Heightmap& heightmap) {
  const std::string& uri = heightmap.uri.value;
  if (uri.empty()) return no_shape("it names no image");
  const std::string path = files_.resolve ? files_.resolve(uri, heightmap.uri.span) : std::string();
  if (path.empty()) return no_shape(uri + " is not found");
  const Vector3& size = heightmap.size.value;
  const auto picture = files_.picture ? files_.picture(path) : nullptr;
  if (!picture) return no_shape(uri + " is not an image that can be read");
  FoundShape found = made(
      {path, {size.x, size.y, size.z}}, [&] { return terrain_mesh(*picture, size); },
      "a size is not positive and finite");
  if (const auto element = elements_.at(geometry.site)) {
    found.offset.translation = read::vector_field(read::child_text(*element, "pos"), {}).value;
  }
  return found;
}

FoundShape ShapeFinder::outlines(const model::Geometry& geometry, const model::Polyline& polyline) {
  std::vector<mass::Outline> outlines;
  const auto element = elements_.at(geometry.site);
  const auto parent = element ? element->parent() : std::nullopt;
  if (parent) outlines = outlines_in(*parent);
  if (outlines.empty()) {
    for (const auto& point : polyline.points) {
      if (outlines.empty()) outlines.emplace_back();
      outlines.front().push_back(point.value);
    }
  }
  std::vector<double> numbers{polyline.height.value};
  for (const mass::Outline& outline : outlines) {
    for (const Vector3& p : outline) numbers.insert(numbers.end(), {p.x, p.y});
    numbers.push_back(HUGE_VAL);  // between two
  }
  return made(
      {{}, std::move(numbers)}, [&] { return drawn_prism(outlines, polyline.height.value); },
      "its outline encloses nothing");
}

/// One for each key, as long as they could all be drawn.
FoundShape ShapeFinder::made(Key key,
                             const std::function<std::shared_ptr<const mesh::TriangleMesh>()>& make,
                             std::string why) {
  FoundShape found;
  const auto known = made_.find(key);
  if (known != made_.end()) {
    found.mesh = known->second;
  } else if (made_triangles_ > kMaxDrawnTriangles) {
    return no_shape("more than " + std::to_string(kMaxDrawnTriangles) + " triangles are not drawn");
  } else {
    found.mesh = make();
    if (found.mesh) made_triangles_ += found.mesh->triangles.size();
    made_.emplace(std::move(key), found.mesh);
  }
  if (!found.mesh) found.why = std::move(why);
  return found;
}

std::shared_ptr<const mesh::TriangleMesh> ShapeFinder::unit_box() {
  return meshes_.of(model::Box{.size = {.value = {1, 1, 1}}}).mesh;
}

FoundShape ShapeFinder::find(const model::Geometry& geometry) {
  const model::Shape& shape = geometry.shape;
  if (const auto* mesh = std::get_if<model::Mesh>(&shape)) return file(*mesh);
  if (const auto* flat = std::get_if<model::Plane>(&shape)) return plane(geometry, *flat);
  if (const auto* land = std::get_if<model::Heightmap>(&shape)) return terrain(geometry, *land);
  if (const auto* lines = std::get_if<model::Polyline>(&shape)) return outlines(geometry, *lines);
  ShapeMesh primitive = meshes_.of(shape);
  FoundShape found;
  found.mesh = std::move(primitive.mesh);
  found.scale = primitive.scale;
  found.why = std::move(primitive.why);
  return found;
}

}  // namespace rigor::view
