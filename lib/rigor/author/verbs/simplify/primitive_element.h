// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Geometry of a collision as an element: a primitive that was fitted, or a mesh.
//
//   const mesh::Primitive shape = readable_primitive(fit.shape);   // sizes of six digits
//   edit(primitive_element(shape, GeometryForm::kUrdf));           // <cylinder radius="0.1" length="0.2"/>
//
// Private to the room.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/model/pose.h>
#include <rigor/robot/robot.h>

namespace rigor::author {

enum class GeometryForm : std::uint8_t { kSdf, kUrdf };

/// What a fit is good for, and what can be read.
mesh::Primitive readable_primitive(mesh::Primitive primitive);

/// As a robot's shape, sizes in m.
robot::Shape primitive_shape(const mesh::Primitive& primitive);

/// Lines are ended by '\n' and indented from nothing.
std::string primitive_element(const mesh::Primitive& primitive, GeometryForm form);
std::string mesh_element(const std::string& uri, const model::Vector3& scale, GeometryForm form);

}  // namespace rigor::author
