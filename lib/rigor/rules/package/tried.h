// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a URI was looked for, as a line of help.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::rules {

/// "tried a (beside the file), b (GZ_SIM_RESOURCE_PATH); set …", the places one after the other.
inline std::string tried_places(const std::vector<std::string>& tried, std::string_view uri) {
  std::string text = tried.empty() ? "no folder is known to look in" : "tried ";
  for (std::size_t i = 0; i < tried.size(); ++i) text.append(i > 0 ? ", " : "").append(tried[i]);
  if (uri.starts_with("package://")) {
    return text + "; name its folder with --package NAME=DIR, or set ROS_PACKAGE_PATH";
  }
  return text + "; name the folder it is in with --model-path, or set GZ_SIM_RESOURCE_PATH";
}

}  // namespace rigor::rules
