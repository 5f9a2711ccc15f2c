// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The project's configuration for what a command looks at.

#pragma once

#include <string>

#include <rigor/config/config.h>

namespace rigor::tool {

/// Of the rigor.toml nearest above `path`; empty when there is none. A UsageError with file and line
/// when something in it cannot stand there.
config::Config config_for(const std::string& path);

}  // namespace rigor::tool
