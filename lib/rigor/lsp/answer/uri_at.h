// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that a document names: meshes, textures, includes of models and of templates.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/lsp/document/analysis.h>
#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

struct FileReference {
  Span where;        ///< in the written document
  std::string path;  ///< of the file or folder that it leads to
};

/// Those that lead to something.
std::vector<FileReference> file_references(const State& state, Analysis& analysis);

/// The one at an offset of the written document.
std::optional<FileReference> reference_at(const State& state, Analysis& analysis,
                                          std::uint32_t offset);

/// The file that the reference at an offset leads to: of a folder with a model, the model's file.
std::optional<std::string> path_at(const State& state, Analysis& analysis, std::uint32_t offset);

}  // namespace rigor::lsp
