// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The `rigor.toml` that a project begins with: every key, explained and commented out, so that it changes
// nothing until somebody takes a `#` away.
//
//   write("rigor.toml", starter_config());

#pragma once

#include <string_view>

namespace rigor::config {

std::string_view starter_config();

}  // namespace rigor::config
