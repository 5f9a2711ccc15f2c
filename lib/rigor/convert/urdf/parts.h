// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a link that `urdf_link` puts together. Private to the room.
//
//   link.inertial = urdf_inertial(draft, id, X_JL);
//   add_link_blocks(draft, id, X_JL, {.script = common_script(source, link)});

#pragma once

#include <optional>
#include <string>

#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/id.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>

namespace rigor::convert {

/// What a consumer of SDF takes it to be, written out.
std::optional<UrdfInertial> urdf_inertial(UrdfDraft& draft, model::Id<model::Link> link,
                                          const model::Pose& X_JL);

/// Keys of a link's block that refer to its visuals or collisions.
struct PartKeys {
  std::string script;   ///< `common_script` of its visuals
  std::string surface;  ///< `surface_lines` of its collisions
};

/// Takes and adds what only `<gazebo reference="link">` can hold.
void add_link_blocks(UrdfDraft& draft, model::Id<model::Link> link, const model::Pose& X_JL,
                     const PartKeys& keys);

/// The pose of a link's part in the URDF link frame, with the author's digits where X_JL is the
/// identity. `X_WP` is the part's pose as `Frames` has it. Takes the pose.
UrdfOrigin origin_in_link(UrdfDraft& draft, model::Id<model::Link> link, const model::Pose& X_JL,
                          const model::PoseField& pose, const std::optional<model::Pose>& X_WP);

}  // namespace rigor::convert
