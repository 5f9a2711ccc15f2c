// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a file so that a reader, and who looks after a crash, sees the old bytes or the new ones, never a part.

#pragma once

#include <string>
#include <string_view>

namespace rigor::tool {

/// Writes a temporary file in the same folder, waits until its bytes are on the disk (fsync) and renames it
/// over `path`, keeping the mode of a file that is replaced; a link is followed. What is no regular file (a pipe, /dev/stderr) is written
/// directly. Throws UsageError when it cannot be written.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace rigor::tool
