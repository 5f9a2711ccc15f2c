// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The changed text of a model in a file of another name: its relative URIs lead where they led.

#pragma once

#include <string>

namespace rigor::tool {

/// Writes what was made of the file `path` to `out`, as `replace_file` does.
void write_moved(const std::string& out, const std::string& path, const std::string& text);

}  // namespace rigor::tool
