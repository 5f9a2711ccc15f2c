// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a model that is alone in its file is kept up in a test: it stands by itself, or its base is held by
// the world, as that of an arm is bolted and that of a legged robot hangs in its frame on the bench. A file
// says nothing of it, so it is chosen by what there is to stand on, and said.
//
//   const MountChoice choice = choose_mount("hold", scene, wheels);
//   scenario.base = choice.base;
//   const Scene held = mounted(scene, choice.base);

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// Of the scene's size: feet are not drawn to the same height, and a robot sinks onto all of them.
inline constexpr double kFeetSlack = 0.01;

struct MountChoice {
  Base base = Base::kFree;
  std::string why;  ///< of a base that is held: "its center of mass is not above what it stands on"
  bool tips_over = false;  ///< it is nothing that is bolted down in use, and falls when it is not
};

/// What `--base auto` means in a test. Free: a world's models, what rolls, what no joint moves, and what
/// stands. Else a base hangs: in joint-sweep always, in settle and hold when the center of mass is not above
/// what the robot stands on. What the world holds already has no ground where it reaches below z = 0.
MountChoice choose_mount(std::string_view test, const Scene& scene, const DriveTrain& wheels);

/// Whether a test asks how a model stands or drives, and so makes no sense of one whose base is held.
bool needs_free_base(std::string_view test);

/// Whether its center of mass is above a support of some width, at the start, and does not only balance there. Level ground is assumed under
/// its lowest point; what is within a hundredth of the scene's size above it touches it once it has settled.
bool stands_by_itself(const Scene& scene, std::uint32_t model);

/// A robot that joints move, without wheels or feet: what touches the ground is its base, or it does not
/// stand. It is used bolted to something.
bool is_to_be_bolted(const Scene& scene, std::uint32_t model, const DriveTrain& wheels);

/// The scene with the base of each model joined to the world where no joint does it, and so what no joint connects
/// to the base, which would fall; as it is when `base` is free.
/// Joints are added at the end, so that no index changes.
Scene mounted(const Scene& scene, Base base);

}  // namespace rigor::simulate
