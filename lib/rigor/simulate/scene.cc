// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene.h>

namespace rigor::simulate {

double moving_mass(const Scene& scene) {
  double sum = 0;
  for (const SceneBody& body : scene.bodies) {
    if (!body.kinematic) sum += body.mass.mass;
  }
  return sum;
}

}  // namespace rigor::simulate
