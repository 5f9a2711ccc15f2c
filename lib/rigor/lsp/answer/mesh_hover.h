// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh file in few words, and as a small picture.

#pragma once

#include <string>

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// Whether a path is that of a mesh, by its ending.
bool is_mesh_path(std::string_view path);

/// Markdown: triangles, extents in the file's own unit, whether it is closed, and why it cannot be read. With a picture
/// where the client shows those and Embree is installed. A file over 16 MB is not read while somebody waits.
std::string mesh_text(const State& state, const std::string& path);

}  // namespace rigor::lsp
