// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <utility>

#include <rigor/read/sdf_reader.h>

namespace rigor::read {
namespace {

using model::Shape;

model::Mesh sdf_mesh(xml::Element element) {
  model::Mesh mesh;
  // SDF 1.0 and URDF call it filename, and it is an attribute there.
  auto uri = child_text(element, "uri");
  if (!uri) uri = child_text(element, "filename");
  mesh.uri = string_field(uri);
  mesh.scale = vector_field(child_text(element, "scale"), {1, 1, 1});
  if (const auto submesh = element.child("submesh")) {
    mesh.submesh = string_field(child_text(*submesh, "name"));
    mesh.center = bool_field(child_text(*submesh, "center"), false);
  }
  return mesh;
}

model::Polyline polyline(xml::Element element) {
  model::Polyline result;
  result.height = number_field(child_text(element, "height"), 1);
  for (const xml::Element child : element.children()) {
    if (child.name() != "point") continue;
    // Two numbers; read as a vector whose z is zero.
    const std::string three = std::string(trimmed(child.text())) + " 0";
    result.points.push_back(vector_field(Text{three, child.text_span()}, {}));
  }
  return result;
}

/// The shape an element represents; nothing when its name is no shape's.
std::optional<Shape> shape_of(xml::Element element) {
  const std::string_view name = element.name();
  const auto number = [element](std::string_view child, double fallback) {
    return number_field(child_text(element, child), fallback);
  };
  const auto vector = [element](std::string_view child, model::Vector3 fallback) {
    return vector_field(child_text(element, child), fallback);
  };
  const auto uri = [element] {
    auto text = child_text(element, "uri");
    return string_field(text ? text : child_text(element, "filename"));
  };
  if (name == "box") return model::Box{vector("size", {1, 1, 1})};
  if (name == "sphere") return model::Sphere{number("radius", 1)};
  if (name == "cylinder") return model::Cylinder{number("radius", 1), number("length", 1)};
  if (name == "capsule") return model::Capsule{number("radius", 0.5), number("length", 1)};
  if (name == "cone") return model::Cone{number("radius", 1), number("length", 1)};
  if (name == "ellipsoid") return model::Ellipsoid{vector("radii", {1, 1, 1})};
  if (name == "plane") return model::Plane{vector("normal", {0, 0, 1})};
  if (name == "mesh") return sdf_mesh(element);
  if (name == "heightmap") return model::Heightmap{uri(), vector("size", {1, 1, 1})};
  if (name == "image") return model::Image{uri()};
  if (name == "polyline") return polyline(element);
  return std::nullopt;
}

}  // namespace

model::Geometry read_geometry(xml::Element parent) {
  model::Geometry geometry;
  const auto element = parent.child("geometry");
  if (!element) return geometry;
  geometry.site = site_of(*element);
  geometry.written = true;
  bool found = false;
  for (const xml::Element child : element->children()) {
    if (child.name() == "empty") geometry.explicitly_empty = true;
    auto shape = shape_of(child);
    if (!shape && geometry.no_shape.span.nowhere()) geometry.no_shape = site_of(child);
    if (!shape) continue;
    // A polyline may be repeated: it then has holes.
    const bool another_outline = found && child.name() == "polyline" &&
                                 std::holds_alternative<model::Polyline>(geometry.shape);
    if (another_outline) continue;
    if (found) {
      geometry.more.push_back(site_of(child));
      continue;
    }
    found = true;
    geometry.site = site_of(child);
    geometry.shape = std::move(*shape);
  }
  if (found) geometry.no_shape = {};
  return geometry;
}

}  // namespace rigor::read
