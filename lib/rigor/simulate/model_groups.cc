// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/model_groups.h>

#include <algorithm>

namespace rigor::simulate {

ModelGroups::ModelGroups(const Scene& scene)
    : scene_(scene), groups_(scene.models.size()), held_(scene.models.size()) {
  for (std::size_t i = 0; i < held_.size(); ++i) held_[i] = scene.models[i].is_static ? 1 : 0;
  for (const SceneJoint& joint : scene.joints) {
    const std::uint32_t child = model_of(joint.child);
    const std::uint32_t parent = model_of(joint.parent);
    if (child != kWorld && parent != kWorld) {
      join(child, parent);
    } else if (joint.type != model::JointType::kGearbox) {
      if (child != kWorld) held_[root(child)] = 1;
      if (parent != kWorld) held_[root(parent)] = 1;
    }
  }
}

std::uint32_t ModelGroups::model_of(std::uint32_t body) const {
  return body == kWorld ? kWorld : scene_.bodies[body].model;
}

void ModelGroups::join(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t one = root(a);
  const std::uint32_t two = root(b);
  groups_.join(one, two);
  held_[std::min(one, two)] |= held_[std::max(one, two)];
}

}  // namespace rigor::simulate
