// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The box, sphere, cylinder or capsule around a mesh, since a primitive is the best collision, and how
// well it fits.
//
// A fit holds every vertex that a triangle uses, and is of the least volume among those tried. A
// sphere is the smallest there is. The others are tried along the coordinate axes, the principal axes
// of the mesh's hull, the normals of its largest faces and its longest edges; the best of these is
// tilted as long as that helps. What lies along the coordinate axes is taken when it is larger by no
// more than `kAlignedVolume`: a pose that can be read beats a thousandth of volume.
//
//   const auto fit = fit_primitive(mesh, FitKind::kBest);
//   if (fit && fit->fill() > 0.9) propose(fit->shape, fit->pose);

#pragma once

#include <cstdint>
#include <optional>

#include <rigor/mesh/primitive/primitive_mesh.h>
#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/pose.h>

namespace rigor::mesh {

enum class FitKind : std::uint8_t {
  kBox,
  kSphere,
  kCylinder,
  kCapsule,
  kBest  ///< of least volume, where each but the sphere must save `kSimplerVolume`
};

inline constexpr double kAlignedVolume = 1e-3;

/// What a box must save on a sphere, a cylinder on those, and a capsule on all, to be the best: the
/// mesh of a ball, being a little slimmer here than there, is no capsule.
inline constexpr double kSimplerVolume = 0.01;

struct Fit {
  Primitive shape;    ///< dimensions in the mesh's unit
  model::Pose pose;   ///< X_MP: of the primitive in the mesh's frame
  double volume = 0;  ///< of the primitive
  double hull_volume = 0;
  std::optional<double> mesh_volume;  ///< when it is closed; negative when it is inside out
  /// How deep inside the primitive the mesh's surface lies at most; outside, there is none of it.
  double deepest = 0;

  /// Which share of the primitive the mesh's hull fills, up to 1.
  double fill() const { return hull_volume / volume; }
};

/// Nothing when the vertices lie in a plane, on a line or in one place, or are not finite: then they
/// have no hull with a volume.
std::optional<Fit> fit_primitive(const TriangleMesh& mesh, FitKind kind);

}  // namespace rigor::mesh
