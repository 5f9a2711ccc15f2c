// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes the robot of a model whose tree and root are known. Private to the room.

#pragma once

#include <rigor/convert/ledger.h>
#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/roots.h>
#include <rigor/convert/urdf/tree.h>

namespace rigor::convert {

/// Fills the result's robot, files and names; the account is the ledger's.
void build_robot(const Source& source, const UrdfOptions& options, const UrdfTree& tree,
                 const UrdfRoots& roots, Ledger& ledger, UrdfConversion& result);

}  // namespace rigor::convert
