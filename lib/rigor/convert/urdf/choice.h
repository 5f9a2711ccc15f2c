// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which model of a file becomes the robot, whether it can, and what stays behind. Private to the room.

#pragma once

#include <string>

#include <rigor/convert/ledger.h>
#include <rigor/convert/note.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/model.h>

namespace rigor::convert {

struct UrdfChoice {
  model::Id<model::Model> model;  ///< none when the notes say why
  Notes notes;
};

/// The model of that name ("arm::hand" is the nested one); the only one when `name` is empty.
UrdfChoice choose_model(const Source& source, const std::string& name);

/// What the model refers to and is not there, so that nobody knows where its parts are.
Notes unresolved_in(const Source& source, const UrdfTree& tree);

/// Accounts for what the file holds beside a model that is the only one.
void lose_surroundings(const Source& source, Ledger& ledger, model::Id<model::Model> model);

}  // namespace rigor::convert
