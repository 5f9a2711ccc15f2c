// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a URDF robot into a `Root`; private to the room. In URDF a link's frame is its joint's, and
// what is not written has no mass.

#pragma once

#include <rigor/model/model.h>
#include <rigor/read/sdf_reader.h>
#include <rigor/xml/document.h>

namespace rigor::read {

model::Id<model::Model> read_urdf(model::Root& root, xml::Element robot, Scope scope);

}  // namespace rigor::read
