// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Robots without motors: exporters write an effort limit of 0 for each joint, and what the joints carry drops. What is
// shown then by a run (links that swing, meet, and jitter at their stops) says nothing more of the model.
//
//   const std::vector<std::uint32_t> joints = unpowered_joints(scene, wheels);
//   if (!joints.empty()) scene = powered(std::move(scene), joints);  // and say so

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/fact.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// The joints of a model alone that would need a motor and have none, where no other of its joints has one and one of
/// these does not stay where it begins. Empty for what is passive on purpose: a door, a pendulum at rest, wheels.
std::vector<std::uint32_t> unpowered_joints(const Scene& scene, const DriveTrain& wheels);

/// As if their limits of 0 were not written.
Scene powered(Scene scene, const std::vector<std::uint32_t>& joints);

/// Of kind kNoMotor, with the joints' names.
Fact about_unpowered(const Scene& scene, const std::vector<std::uint32_t>& joints);

}  // namespace rigor::simulate
