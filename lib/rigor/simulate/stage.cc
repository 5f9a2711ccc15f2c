// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/stage.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <rigor/simulate/model_groups.h>
#include <rigor/simulate/mount.h>
#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

void add_stage_ground(Scene& scene, double mu) {
  SceneShape ground{.name = "ground", .kind = HalfSpace{}, .extent = kInfinity};
  ground.surface.mu = mu;
  ground.surface.mu2 = mu;
  scene.shapes.push_back(ground);
}

void raise_stage_models(Scene& scene, const ModelGroups& groups, const std::vector<double>& by) {
  const auto height = [&](std::uint32_t body) {
    return body == kWorld ? 0 : by[groups.root(scene.bodies[body].model)];
  };
  for (SceneBody& body : scene.bodies) body.X_WB.translation.z += by[groups.root(body.model)];
  for (SceneJoint& joint : scene.joints) {
    joint.anchor_W.z += height(joint.child == kWorld ? joint.parent : joint.child);
  }
}

}  // namespace

Scene stage(const Scene& scene, const Scenario& scenario) {
  Scene staged = scene;
  if (scenario.gravity_W) staged.gravity = *scenario.gravity_W;
  if (!scenario.gravity) staged.gravity = {};
  const ModelGroups groups(scene);
  const std::size_t models = scene.models.size();
  std::vector<double> lowest(models, kInfinity);
  for (std::uint32_t i = 0; i < models; ++i) {
    double& low = lowest[groups.root(i)];
    low = std::min(low, lowest_of_model(scene, i));
  }
  std::vector<double> by(models, 0);
  for (std::uint32_t i = 0; i < models; ++i) {
    if (groups.held(groups.root(i))) continue;
    // What stands in a world stands on other things than its ground.
    const bool down = scenario.spawn == Spawn::kOnGround && scene.alone && lowest[i] < kInfinity;
    by[i] = (down ? -lowest[i] : 0) + scenario.drop;
  }
  raise_stage_models(staged, groups, by);
  if (scenario.base != Base::kFree) staged = mounted(staged, scenario.base);
  if (scene.alone && scenario.ground && scenario.base != Base::kHang)
    add_stage_ground(staged, scenario.ground_mu);
  return staged;
}

}  // namespace rigor::simulate
