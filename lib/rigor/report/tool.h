// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Who wrote a report: the program's version, and those of the engines its results depend on.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor::report {

inline constexpr std::string_view kToolName = "rigor";

/// Of the shape of every JSON report; grows when a reader of the last one would be misled.
inline constexpr int kSchemaVersion = 1;

/// "0.1.0"
std::string_view tool_version();

struct Engine {
  std::string name;
  std::string version;
};

/// What is linked in, by name.
std::vector<Engine> engines();

std::string version_text();
std::string version_json();

}  // namespace rigor::report
