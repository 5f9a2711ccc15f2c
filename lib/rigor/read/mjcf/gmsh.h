// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What MuJoCo's <flexcomp type="gmsh"> takes of GMSH's mesh format (gmsh.info/doc/texinfo, "MSH file format"): the
// versions 4.1 and 2.2, one block of nodes and one of triangles or tetrahedra.

#pragma once

#include <string>
#include <string_view>

namespace rigor::read {

/// Why MuJoCo rejects the file; empty when it takes it. Of binary files the sections alone are checked.
std::string gmsh_problem(std::string_view bytes);

}  // namespace rigor::read
