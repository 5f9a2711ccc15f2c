// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/stage.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <rigor/simulate/reach.h>

namespace rigor::simulate {
namespace {

/// Models that joints hold together, and which of them hang on the world.
class StageGroups {
 public:
  explicit StageGroups(const Scene& scene)
      : scene_(scene), parent_(scene.models.size()), fixed_(scene.models.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (std::size_t i = 0; i < fixed_.size(); ++i) fixed_[i] = scene.models[i].is_static ? 1 : 0;
    for (const SceneJoint& joint : scene.joints) {
      const std::uint32_t child = model_of(joint.child);
      const std::uint32_t parent = model_of(joint.parent);
      if (child != kWorld && parent != kWorld) {
        join(child, parent);
      } else if (joint.type != model::JointType::kGearbox) {
        if (child != kWorld) fixed_[root(child)] = 1;
        if (parent != kWorld) fixed_[root(parent)] = 1;
      }
    }
  }

  std::uint32_t root(std::uint32_t model) const {
    while (parent_[model] != model) model = parent_[model];
    return model;
  }
  bool fixed(std::uint32_t root) const { return fixed_[root] != 0; }

 private:
  std::uint32_t model_of(std::uint32_t body) const {
    return body == kWorld ? kWorld : scene_.bodies[body].model;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t one = root(a);
    const std::uint32_t two = root(b);
    parent_[std::max(one, two)] = std::min(one, two);
    fixed_[std::min(one, two)] |= fixed_[std::max(one, two)];
  }

  const Scene& scene_;
  std::vector<std::uint32_t> parent_;
  std::vector<unsigned char> fixed_;
};

void add_stage_ground(Scene& scene, double mu) {
  SceneShape ground{.name = "ground", .kind = HalfSpace{}, .extent = kInfinity};
  ground.surface.mu = mu;
  ground.surface.mu2 = mu;
  scene.shapes.push_back(ground);
}

void raise_stage_models(Scene& scene, const StageGroups& groups, const std::vector<double>& by) {
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
  const StageGroups groups(scene);
  const std::size_t models = scene.models.size();
  std::vector<double> lowest(models, kInfinity);
  for (std::uint32_t i = 0; i < models; ++i) {
    double& low = lowest[groups.root(i)];
    low = std::min(low, lowest_of_model(scene, i));
  }
  std::vector<double> by(models, 0);
  for (std::uint32_t i = 0; i < models; ++i) {
    if (groups.fixed(groups.root(i))) continue;
    // What stands in a world stands on other things than its ground.
    const bool down = scenario.spawn == Spawn::kOnGround && scene.alone && lowest[i] < kInfinity;
    by[i] = (down ? -lowest[i] : 0) + scenario.drop;
  }
  raise_stage_models(staged, groups, by);
  if (scene.alone && scenario.ground) add_stage_ground(staged, scenario.ground_mu);
  return staged;
}

}  // namespace rigor::simulate
