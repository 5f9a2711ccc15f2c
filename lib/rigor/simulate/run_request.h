// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is to be run, as the bytes that go to a worker: a scene, a scenario and settings. Private to the room.
//
//   const std::string bytes = encode_run(scene, scenario, settings);
//   std::optional<RunRequest> request = decode_run(bytes);

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

struct RunRequest {
  Scene scene;
  Scenario scenario;
  SolverSettings settings;
};

/// Of meshes only what a run sees: positions and triangles.
std::string encode_run(const Scene& scene, const Scenario& scenario,
                       const SolverSettings& settings);

/// Nothing when the bytes are damaged.
std::optional<RunRequest> decode_run(std::string_view bytes);

}  // namespace rigor::simulate
