// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that a pattern of `xacro:include` means, as Python's `glob` finds them: `*`, `?` and `[a-z]`
// within a part of a path, hidden files only where the pattern writes their dot.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::xacro {

bool is_file_pattern(std::string_view path);

/// Paths in the order of their bytes, at most `most` of them.
std::vector<std::string> matching_files(const Disk& disk, std::string_view pattern,
                                        std::size_t most);

/// Whether a part of a path matches; what it costs is bounded by the product of the lengths.
bool matches_part(std::string_view name, std::string_view pattern);

}  // namespace rigor::xacro
