// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene's bodies as a tree, as MuJoCo has them: every body hangs on its parent by at most one joint. A joint that
// closes a loop carries a half of a body, which is welded to the other half: so all of the joint (its limits, motor,
// friction) is as that of any other. Private to the folder.
//
//   for (const TreeNode& node : scene_tree(scene)) write(node);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

struct TreeNode {
  enum class Held : std::uint8_t {
    kByJoint,
    kFree,      ///< floats
    kByNothing  ///< kinematic: stays where it is
  };

  std::uint32_t body = 0;         ///< of the scene
  std::uint32_t parent = kWorld;  ///< a node before this one
  std::uint32_t joint = kWorld;   ///< of the scene, that carries it
  Held held = Held::kFree;
  bool reversed = false;  ///< the joint's child carries its parent
  bool half = false;      ///< of a loop: welded to the body's first node
  double share = 1;       ///< of the body's mass and inertia
};

/// Parents before children; the first node of a body is the one that has its shapes and its children.
std::vector<TreeNode> scene_tree(const Scene& scene);

/// Joint types that carry a body: not gearboxes, and not what only closes a loop by holding all.
bool carries(const SceneJoint& joint);

}  // namespace rigor::simulate
