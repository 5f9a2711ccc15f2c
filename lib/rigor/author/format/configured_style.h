// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The layout that `[format]` of a rigor.toml asks for.

#pragma once

#include <rigor/author/format/format_style.h>
#include <rigor/config/config.h>

namespace rigor::author {

/// What the configuration does not say is as a `FormatStyle` has it.
FormatStyle configured_style(const config::Layout& layout);

}  // namespace rigor::author
