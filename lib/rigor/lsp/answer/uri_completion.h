// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The next step of a URI that is typed: files and folders of where it leads so far.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

struct UriStep {
  std::string text;
  std::uint32_t begin = 0;  ///< of what it replaces, in what was typed
  bool is_folder = false;
};

/// For what stands in the file at a path. Folders that are searched are listed after `model://`.
std::vector<UriStep> uri_steps(const State& state, const std::string& path, std::string_view typed);

}  // namespace rigor::lsp
