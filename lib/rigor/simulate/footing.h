// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What keeps each model up as a run begins: so much of it as can be said to be still afterwards.
//
//   const std::vector<Footing> footings = footings_of(scene);
//   if (footings[m].kind == Footing::Kind::kStands) judge_rest(m);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

struct Footing {
  enum class Kind : std::uint8_t {
    kStands,  ///< on the ground, on what stands, or a short fall above; a static model too
    kHangs,   ///< joints hold it to the world
    kInTheAir,
  };
  Kind kind = Kind::kStands;
  double gap = 0;  ///< m to what is below it, of what is in the air; infinite when nothing is
};

/// Of each model. In a world only: a model alone gets ground under it. What is below is found by bounds,
/// so what is in a room, or beside a hill, stands.
std::vector<Footing> footings_of(const Scene& scene);

/// Of each body, whether it may move for as long as energy lasts: it is in the air, or hangs on joints
/// of which one has no command, or no effort.
std::vector<bool> moving_freely(const Scene& scene, const Scenario& scenario);

}  // namespace rigor::simulate
