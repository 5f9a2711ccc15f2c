// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Tells whether two shapes are the same but for their place.
//
//   if (shape_key(collision.geometry.shape) == shape_key(visual.geometry.shape)) compare_places();

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <rigor/model/geometry.h>

namespace rigor::rules {

/// Kind, sizes and file.
struct ShapeKey {
  std::size_t kind = 0;
  std::array<double, 3> sizes{};  ///< m, in the order of the shape's members; a mesh's scale
  std::string file;

  auto operator<=>(const ShapeKey&) const = default;
};

/// Nothing for a shape whose size is not written, and for planes, heightmaps, images and outlines.
inline std::optional<ShapeKey> shape_key(const model::Shape& shape) {
  ShapeKey key{.kind = shape.index()};
  const auto add = [&key](const model::Vector3& v) { key.sizes = {v.x, v.y, v.z}; };
  const auto add_round = [&key](const auto& round) {
    key.sizes = {round.radius.value, round.length.value};
    return round.radius.written && round.length.written;
  };
  bool known = false;
  if (const auto* box = std::get_if<model::Box>(&shape)) {
    add(box->size.value);
    known = box->size.written;
  } else if (const auto* sphere = std::get_if<model::Sphere>(&shape)) {
    key.sizes = {sphere->radius.value};
    known = sphere->radius.written;
  } else if (const auto* ellipsoid = std::get_if<model::Ellipsoid>(&shape)) {
    add(ellipsoid->radii.value);
    known = ellipsoid->radii.written;
  } else if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) {
    known = add_round(*cylinder);
  } else if (const auto* capsule = std::get_if<model::Capsule>(&shape)) {
    known = add_round(*capsule);
  } else if (const auto* cone = std::get_if<model::Cone>(&shape)) {
    known = add_round(*cone);
  } else if (const auto* mesh = std::get_if<model::Mesh>(&shape)) {
    add(mesh->scale.value);
    key.file =
        mesh->uri.value + '\n' + mesh->submesh.value + (mesh->center.value ? "\ncentered" : "");
    known = !mesh->uri.value.empty();
  }
  if (!known) return std::nullopt;
  return key;
}

}  // namespace rigor::rules
