// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/scene.h>

#include <algorithm>

namespace rigor::simulate {

bool jointed(const Scene& scene, std::uint32_t body_a, std::uint32_t body_b) {
  return std::any_of(scene.joints.begin(), scene.joints.end(), [&](const SceneJoint& joint) {
    return (joint.parent == body_a && joint.child == body_b) ||
           (joint.parent == body_b && joint.child == body_a);
  });
}

double moving_mass(const Scene& scene) {
  double sum = 0;
  for (const SceneBody& body : scene.bodies) {
    if (!body.kinematic) sum += body.mass.mass;
  }
  return sum;
}

}  // namespace rigor::simulate
