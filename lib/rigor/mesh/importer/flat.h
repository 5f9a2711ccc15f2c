// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A loaded mesh as one run of bytes, to hand it from one process to another of the same program.
//
//   std::string bytes = flatten(loaded);                        // in the worker
//   std::optional<LoadedMesh> loaded = unflatten(result.bytes);  // in the parent

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/mesh/read.h>

namespace rigor::mesh {

std::string flatten(const LoadedMesh& loaded);

/// Believes nothing, since a damaged process may have written the bytes: nothing comes back unless
/// all lengths fit, every corner names a vertex, the parts cover the triangles, and what corners
/// carry is there for each or none.
std::optional<LoadedMesh> unflatten(std::string_view bytes);

}  // namespace rigor::mesh
