// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings of files beside models, which `validate` does not know: `rigor.toml`, SRDF, `package.xml`.
//
// An SRDF is held against the robots of the workspace that have its name: its links and joints exist, its states are
// within the joints' limits, its groups are defined. Of `package.xml` the folders that it exports to Gazebo exist.

#pragma once

#include <vector>

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

/// None for a document of another kind.
std::vector<Json> companion_diagnostics(State& state, OpenDocument& document);

}  // namespace rigor::lsp
