// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Siblings that share a name in SDF 1.6 and older: libsdformat renames the later kind and goes on,
// and so every consumer knows it by the new name. Private to the room.

#pragma once

#include <rigor/model/model.h>

namespace rigor::read {

/// Gives joints and frames of a model whose name a sibling of another kind has an `alias`.
void rename_siblings(model::Root& root, model::Id<model::Model> model);

}  // namespace rigor::read
