// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene with its joints moved: forward kinematics of what was made already, without reading a file again.
//
//   Posing posing(scene);
//   std::vector<double> positions = posing.start();
//   positions[elbow] = 0.5;
//   const Scene& bent = posing.at(positions);

#pragma once

#include <cstdint>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

class Posing {
 public:
  explicit Posing(const Scene& scene);

  /// Whether joints move by themselves: none closes a loop, none is held by another one but as a mimic does.
  bool is_tree() const { return tree_; }

  /// Of each joint its first axis' position as the scene has it, rad or m; 0 where it has none.
  const std::vector<double>& start() const { return start_; }

  /// The scene with hinges and sliders at `positions` (as `start()`), and their mimics where those lead. Limits are the
  /// caller's business. Valid until the next call.
  const Scene& at(std::vector<double> positions);

 private:
  void follow(std::vector<double>& positions) const;
  void move(std::uint32_t joint, double by);

  Scene scene_;
  std::vector<SceneBody> bodies_;                    // as they began
  std::vector<SceneJoint> joints_;                   // likewise
  std::vector<std::vector<std::uint32_t>> carried_;  // bodies, of each joint
  std::vector<double> start_;
  bool tree_ = true;
};

}  // namespace rigor::simulate
