// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Why a simulation may have gone wrong, looked for in the model itself: inertias that are not those of
// the links' shapes, mass ratios across joints, wheels off their axis, overlaps, casters with friction.
//
//   for (const Fact& cause : causes_in(scene, input, wheels)) add(cause);
//
// Each cause says how bad it is (`value` against `limit`). `explain` picks those that can be behind what
// a run showed, so that a message that says "drives backwards" also says what to change.

#pragma once

#include <rigor/simulate/fact.h>
#include <rigor/simulate/scene/build.h>
#include <rigor/simulate/scene/scene.h>
#include <rigor/simulate/wheels.h>

namespace rigor::simulate {

/// All that is suspicious, the worst first. `input` is what the scene was made from.
Facts causes_in(const Scene& scene, const SceneInput& input, const DriveTrain& wheels);

/// Of the causes those that can be behind a fact, the likeliest first; at most three.
Facts explain(const Fact& shown, const Facts& causes);

}  // namespace rigor::simulate
