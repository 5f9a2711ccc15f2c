// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `<include merge="true">`: the parts of the included model become parts of the one around it.
// Private to the room.

#pragma once

#include <rigor/model/model.h>

namespace rigor::read {

/// Moves the parts of `inner` into its parent. What stays of it is a frame, as libsdformat keeps one:
/// `_merged__NAME__model__`, which the parts that meant "the model" now refer to by name.
void merge_into_parent(model::Root& root, model::Id<model::Model> inner);

}  // namespace rigor::read
