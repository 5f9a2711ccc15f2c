// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a physics engine can take a scene. ODE ends the process on half of what is wrong here, and
// takes the other half without a word and spoils it (NaN masses, planes without a normal, crossed
// limits, triangles that name no corner). `build_scene` says the same of values where they stand in the
// file; this is the last look, and the only one at scenes that are made by hand.
//
//   Facts facts = check_scene(scene);
//   if (facts.empty()) Engine engine(scene, scene.solver);

#pragma once

#include <cstddef>

#include <rigor/simulate/fact.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// Of 1,350 real files the largest, a demonstration of speed, has 3,003 bodies, the next one 100. Pairs
/// of shapes are all examined in each step.
inline constexpr std::size_t kMaxBodies = 5'000;
inline constexpr std::size_t kMaxShapes = 10'000;
inline constexpr std::size_t kMaxJoints = 5'000;
/// Of all meshes together: ODE takes 100 bytes for each.
inline constexpr std::size_t kMaxSceneTriangles = 5'000'000;

/// At most one fact of each body, shape, joint and mesh; all are severe.
Facts check_scene(const Scene& scene);

/// Only whether there is too much of something, which needs no look at any of it.
Facts check_counts(const Scene& scene);

}  // namespace rigor::simulate
