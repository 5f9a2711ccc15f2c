// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Sets a scene up as a scenario wants it: with ground under a model that brings none, set down on it,
// lifted for a drop.
//
//   const Scene staged = stage(scene, scenario);

#pragma once

#include <rigor/simulate/scenario.h>
#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

Scene stage(const Scene& scene, const Scenario& scenario);

}  // namespace rigor::simulate
