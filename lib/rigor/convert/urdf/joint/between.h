// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The links between the joints in a row that represent one. Simulators move nothing without mass: MuJoCo
// refuses the file, and libsdformat drops the link with all that hangs on it. So each gets as much as
// these want, and the link that the row carries has so much less: together they are the same body at all
// joint positions, since each of them is a ball at the place where the axes meet. Private to the room.

#pragma once

#include <rigor/convert/urdf/draft.h>

namespace rigor::convert {

/// Gives `draft.rows` their masses and tells it. All links are in the draft.
void weigh_links_between(UrdfDraft& draft, model::Id<model::Model> model);

}  // namespace rigor::convert
