// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Refuses to write what a command makes over what it reads, or over what it writes besides.

#pragma once

#include <CLI/CLI.hpp>

namespace rigor::tool {

/// A UsageError where a file of -o, --output or --report is also read, links followed, or is named twice.
/// Commands that write a changed copy of what they read (`mesh-check`, `merge`, `upgrade`) may put it in its
/// place with -o. What is to be called before a parsed command runs.
void refuse_outputs_over_inputs(const CLI::App& command);

}  // namespace rigor::tool
