// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which body of a model is its base: the root of its tree of joints. The first link of a file may be any
// link, a wheel too.

#include <cstdint>
#include <vector>

#include <rigor/simulate/joint_load.h>
#include <rigor/simulate/scene/draft.h>

namespace rigor::simulate {
namespace {

/// What joints of its model have as their child; a gearbox holds nothing.
std::vector<bool> held_bodies(const Scene& scene) {
  std::vector<bool> held(scene.bodies.size());
  for (const SceneJoint& joint : scene.joints) {
    if (joint.child >= held.size() || joint.type == model::JointType::kGearbox) continue;
    const bool within = joint.parent == kWorld ||
                        scene.bodies[joint.parent].model == scene.bodies[joint.child].model;
    if (within) held[joint.child] = true;
  }
  return held;
}

double carried_mass(const Scene& scene, const CarriedBodies& carried, std::uint32_t body) {
  double mass = 0;
  for (const std::uint32_t b : carried.by(body)) mass += scene.bodies[b].mass.mass;
  return mass;
}

}  // namespace

void choose_bases(SceneDraft& draft) {
  Scene& scene = draft.scene;
  const std::vector<bool> held = held_bodies(scene);
  const CarriedBodies carried(scene);
  // Of a model that hangs on the world, or is a ring, all is held by something: its canonical link is as
  // good as any.
  std::vector<double> heaviest(scene.models.size(), -1);
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    if (held[b]) continue;
    const std::uint32_t model = scene.bodies[b].model;
    const double mass = carried_mass(scene, carried, b);
    if (mass <= heaviest[model]) continue;
    heaviest[model] = mass;
    scene.models[model].base = b;
  }
}

}  // namespace rigor::simulate
