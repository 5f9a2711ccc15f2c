// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings that hold for a file, for programs.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigor::report {

/// One setting, and who says it: an option of the command line, a line of a configuration, or nobody.
struct SettingLine {
  std::string key;  ///< "severity.axis-zero"
  std::string value;
  std::string option;
  std::string path;  ///< of the configuration
  std::uint32_t line = 0;
};

/// `configurations` are the files that hold for `file`, each before the one that it extends.
std::string settings_json(const std::string& file, const std::vector<std::string>& configurations,
                          const std::vector<SettingLine>& settings);

}  // namespace rigor::report
