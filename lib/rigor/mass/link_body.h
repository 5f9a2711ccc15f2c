// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a link weighs and how it is spread, from its collisions or visuals taken as solids.
//
//   LinkBody body = link_body(root, frames, id, From::kCollisions, find_mesh);
//   if (body.complete()) MassProperties water = of_densities(body, 1000);
//
// Each shape is a solid of even density; a mesh is what it encloses, or its convex hull when it is no
// solid (mass/mesh/survey.h). Shapes that overlap count twice, as they do for libsdformat and MuJoCo;
// `overlaps_in` names them.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/find_mesh.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/mass/mesh/state.h>
#include <rigor/mass/overlap.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::mass {

enum class From : std::uint8_t { kCollisions, kVisuals };

/// Why a shape is no solid.
enum class NoSolid : std::uint8_t {
  kNone,       ///< it is one
  kNoShape,    ///< there is no shape
  kSize,       ///< a size is not positive or not finite
  kUnbounded,  ///< a plane, heightmap or image has no volume
  kNoMesh,     ///< the mesh's file is not found or was not opened
  kMesh,       ///< see `mesh`: unusable, or flat
  kOutline,    ///< the polyline crosses itself, or has no area
  kFrame,      ///< where it is in the link cannot be told: its pose is relative to another frame
};

struct PartBody {
  std::string name;  ///< of the collision or visual; "visual 2" for one without
  Span where;        ///< the name of the shape's element
  NoSolid why = NoSolid::kNone;
  MeshState mesh = MeshState::kSolid;  ///< of a mesh
  BodyFrom from = BodyFrom::kMesh;     ///< of a mesh
  double density = 1000;  ///< kg/m³: SDF 1.11's `<density>`, else the link's, else 1000
  /// At density 1 (so that its mass is its volume, m³), in the link frame.
  MassProperties unit;
};

struct LinkBody {
  From from = From::kCollisions;
  std::vector<PartBody> parts;

  /// Whether there are parts, and all of them are solids.
  bool complete() const;
};

LinkBody link_body(const model::Root& root, const model::Frames& frames,
                   model::Id<model::Link> link, From from, const FindMesh& find_mesh);

/// Two parts that share space.
struct PartOverlap {
  std::size_t first = 0;  ///< index in `parts`
  std::size_t second = 0;
  double share = 0;  ///< of the smaller one's volume, to two digits
};

/// Pairs of parts so near each other that their volumes are compared, in the order of the parts; those beyond are left
/// out. A comparison takes up to a millisecond, and a thousand parts in one place are half a million pairs.
inline constexpr std::size_t kMaxCompared = 1000;

struct PartOverlaps {
  std::vector<PartOverlap> list;
  bool complete = true;  ///< no pair was left out
};

/// The pairs that do, meshes aside.
PartOverlaps overlaps_in(const model::Root& root, const model::Frames& frames,
                         model::Id<model::Link> link, From from);

/// At one density for all parts, kg/m³, in the link frame.
MassProperties of_density(const LinkBody& body, double density);

/// At the densities that the parts have themselves.
MassProperties of_own_densities(const LinkBody& body);

}  // namespace rigor::mass
