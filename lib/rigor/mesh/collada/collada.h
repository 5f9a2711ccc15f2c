// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collada 1.4 and 1.5 without animation, for files that the importer of scenes refuses for what has
// nothing to do with shapes, such as a texture that is not defined: 9 of 268 files of gazebo_models,
// which Gazebo opens.
//
// Conventions are those of read_scene (mesh/importer/scene.h): the <unit> is applied, <up_axis> is not; mirrored
// nodes keep their outside outside. One part a group of polygons and node; what corners carry and
// how materials look is as mesh/importer/bake.h says. A picture that is not defined is none.
//
//   LoadedMesh loaded = read_collada(bytes);

#pragma once

#include <cstdint>
#include <string_view>

#include <rigor/mesh/read.h>

namespace rigor::mesh {

/// Larger files are refused: the scanner takes about five times their size of memory. The largest
/// seen among 3,400 real models has 30 MB.
inline constexpr std::uint64_t kMaxColladaBytes = std::uint64_t{256} << 20U;

/// Nodes and geometries that are visited, and parts that there are: since nodes can be instanced in
/// instanced nodes, a small file can ask for any number. The most in a real model is some thousands.
inline constexpr std::uint64_t kMaxColladaVisits = 1'000'000;

/// Text of numbers that is read: many groups and geometries may name the same, which hardly any do.
inline constexpr std::uint64_t kMaxColladaReading = 4 * kMaxColladaBytes;

LoadedMesh read_collada(std::string_view bytes);

}  // namespace rigor::mesh
