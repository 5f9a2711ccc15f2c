// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace rigor::xml {

/// The version of tinyxml2 that gives the second opinion: "9.0.0".
std::string tinyxml2_version();

}  // namespace rigor::xml
