// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The axis that a round part is round about, by the size of its bounds: a wheel's, a motor's, a mast's.
//
//   const auto axis = round_axis(mesh.bounds.max - mesh.bounds.min);
//   if (axis == Axis::kY) say("it lies along y");

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <rigor/model/geometry.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class Axis : std::uint8_t { kX, kY, kZ };

constexpr char to_letter(Axis axis) { return "xyz"[static_cast<unsigned>(axis)]; }

/// Of a box about it (m, or any unit), when two of its sides are equal and the third is another. Nothing of a cube,
/// and of a box without two equal sides.
std::optional<Axis> round_axis(const model::Vector3& size);

/// Of a body with these vertices. Where its size does not tell, as of a wheel as wide as high: the only axis through
/// the middle of its bounds from which no vertex is farther than half the other two sides. Nothing of a ball, of
/// which all are such, and of a cube, of which none is.
std::optional<Axis> round_axis(std::span<const model::Vector3> vertices);

/// Of a shape in its own frame. Nothing of meshes, whose size the shape does not say.
std::optional<Axis> round_axis(const model::Shape& shape);

/// The rotation, rad, as roll, pitch and yaw, that brings an axis onto another.
model::Vector3 turn_between(Axis from, Axis to);

}  // namespace rigor::author
