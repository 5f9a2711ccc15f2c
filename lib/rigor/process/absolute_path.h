// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace rigor::process {

/// `path` from the root, normalized, as the working folder has it; the disk is not asked. Only normalized where the
/// working folder is gone.
std::string absolute_path(std::string_view path);

}  // namespace rigor::process
