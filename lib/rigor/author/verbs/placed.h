// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything in a model that has a pose of its own, whatever it is, so that a verb that moves frames forgets nothing.
//
//   for (const Placed& each : placed_in(edited))
//     if (each.X_WF) draft.set_pose(*each.field, each.holder, compose(X_change, each.field->pose.value));
//
// Private to the room.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/model/model.h>
#include <rigor/xml/document.h>

namespace rigor::author {

enum class PlacedKind : std::uint8_t {
  kModel,  ///< nested
  kInclude,
  kLink,
  kJoint,
  kFrame,
  kInertial,
  kCollision,
  kVisual,
  kSensor,
  kLight,
  kEmitter,  ///< a particle emitter, projector or audio source
};

struct Placed {
  PlacedKind kind{};
  model::PoseField field;
  xml::Element holder;              ///< of the `<pose>` or `<origin>`, or of its place
  std::optional<model::Pose> X_WF;  ///< at rest: of the frame that the pose is in
  model::Id<model::Link>
      link;  ///< that it is in; of a link itself, of a joint its child, of a frame its carrier
  model::Id<model::Model> scope;  ///< in which names are looked up
  std::uint32_t index = 0;        ///< of the entity in the root's list; of an inertial, its link's
  bool on_joint = false;          ///< an SDF sensor in a joint, in whose frame its pose is
};

/// Those of the model and of models nested in it that the file itself holds, not the model's own. A URDF's links have
/// no poses. Of sensors and emitters that URDF has no list of there is no index.
std::vector<Placed> placed_in(const EditedModel& edited);

/// Whether all that the model holds is in its file; else the path of one that it includes.
std::optional<std::string> included_part(const EditedModel& edited);

}  // namespace rigor::author
