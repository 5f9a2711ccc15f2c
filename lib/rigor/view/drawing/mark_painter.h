// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Puts marks on a canvas: the inertia, center of mass and frame of each link, the axes of joints, and where
// collisions touch. Marks are as large as suits the model around them. Private to the room.
//
//   MarkPainter marks(root, frames, finder, canvas);
//   marks.draw(Layer::kFrames);

#pragma once

#include <string>

#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/view/drawing/canvas.h>
#include <rigor/view/drawing/marks.h>
#include <rigor/view/drawing/shape_finder.h>

namespace rigor::view {

/// "arm::hand/link palm"
std::string name_of(const model::Root& root, model::Id<model::Link> link);

class MarkPainter {
 public:
  MarkPainter(const model::Root& root, const model::Frames& frames, ShapeFinder& finder,
              Canvas& canvas)
      : root_(root), frames_(frames), finder_(finder), canvas_(canvas) {}

  /// Nothing for layers that are no marks.
  void draw(Layer layer);

 private:
  void draw_masses(Layer layer);
  void add_inertia(Body body, const model::Pose& X_WL, const mass::MassProperties& mass);
  void draw_frames();
  void draw_axes();
  void draw_contacts();
  std::vector<model::Vector3> points_of(model::Id<model::Collision> id);
  void touch_each_other(const Mark& mark);
  void add_mark(Body body, const Mark& mark, double share);
  void note_places();

  const model::Root& root_;
  const model::Frames& frames_;
  ShapeFinder& finder_;
  Canvas& canvas_;
  bool noted_ = false;
};

}  // namespace rigor::view
