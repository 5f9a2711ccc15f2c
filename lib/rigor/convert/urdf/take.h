// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a model says of itself and of where its parts are, taken in the account. Private to the room.

#pragma once

#include <rigor/convert/ledger.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/model/model.h>

namespace rigor::convert {

/// The element with the attributes that say how it is to be read. One that cannot be read is not
/// taken.
void take_pose(const Source& source, Ledger& ledger, const model::PoseField& pose,
               Outcome outcome = Outcome::kConverted);

/// The model's own element and name, and the include that brought it; not its pose. What the include
/// says instead of the model's file is implied there.
void take_model(const Source& source, Ledger& ledger, model::Id<model::Model> model);

}  // namespace rigor::convert
