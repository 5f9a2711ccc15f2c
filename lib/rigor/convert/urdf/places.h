// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the links, joints and frames of a model are in its frame M, by as little arithmetic as can be:
// a pose that is written relative to what is asked for is not computed at all. Private to the room.

#pragma once

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>

namespace rigor::convert {

class UrdfPlaces {
 public:
  /// All of the model's parts have poses.
  UrdfPlaces(const model::Root& root, const model::Frames& frames, model::Id<model::Model> model);

  const model::Pose& X_WM() const {
    return X_WM_;
  }  ///< of the model in the world, or in `__root__`
  model::Pose X_M(model::Id<model::Link> link) const;
  model::Pose X_M(model::Id<model::Joint> joint) const;
  model::Pose X_M(model::Id<model::Frame> frame) const;
  /// The pose of a joint in the link that it carries.
  model::Pose X_L(model::Id<model::Joint> joint, model::Id<model::Link> child) const;

 private:
  bool is_in_model_frame(const model::PoseField& pose, model::Id<model::Model> scope) const;
  bool is_in_link_frame(const model::Joint& joint, model::Id<model::Link> child) const;
  model::Pose in_model(const model::Pose& X_W) const;

  const model::Root& root_;
  const model::Frames& frames_;
  model::Id<model::Model> model_;
  model::Pose X_WM_;
  model::Pose X_MW_;
};

}  // namespace rigor::convert
