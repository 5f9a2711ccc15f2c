// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The text form of STL: solids of facets of three vertices. What stands after `facet normal` is not
// examined: consumers take the normal from the corners, and many writers put `nan` there.
//
//   LoadedMesh loaded = read_ascii_stl("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n…");

#pragma once

#include <string_view>

#include <rigor/mesh/read.h>

namespace rigor::mesh {

LoadedMesh read_ascii_stl(std::string_view bytes);

}  // namespace rigor::mesh
