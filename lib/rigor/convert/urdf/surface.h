// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Friction, contact and reflection of a link's collisions as the keys of its `<gazebo>` block, which refer to the
// whole link. Private to the room.

#pragma once

#include <string>
#include <vector>

#include <rigor/convert/urdf/draft.h>
#include <rigor/model/id.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// The lines of the keys in which all these collisions of a link agree; the values are taken. Values
/// that differ are lost, and noted.
std::string surface_lines(UrdfDraft& draft, model::Id<model::Link> link,
                          const std::vector<model::Id<model::Collision>>& collisions);

}  // namespace rigor::convert
