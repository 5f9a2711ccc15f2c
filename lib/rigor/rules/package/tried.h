// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a URI was looked for, as a line of help.

#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::rules {

/// Places that are listed: what to do is of more use, and `rigor resolve` prints the whole search.
inline constexpr std::size_t kMaxTriedListed = 3;

/// As a shell takes it for one word.
inline std::string shell_word(std::string_view text) {
  if (text.find_first_of(" \t'\"\\$`&;()<>|*?[]#~!{}") == std::string_view::npos)
    return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

/// What to do first, then "tried a (beside the file), b (GZ_SIM_RESOURCE_PATH) and 4 more: rigor resolve …",
/// the command that lists them all for the file.
inline std::string tried_places(const std::vector<std::string>& tried, std::string_view uri,
                                std::string_view file) {
  std::string text;
  constexpr std::string_view kPackage = "package://";
  if (uri.starts_with(kPackage)) {
    const std::string_view rest = uri.substr(kPackage.size());
    text.append("give the folder of the package with --package ")
        .append(rest.substr(0, rest.find('/')))
        .append("=DIR, or set ROS_PACKAGE_PATH");
  } else {
    text = "give the folder that it is in with --model-path DIR, or set GZ_SIM_RESOURCE_PATH";
  }
  if (tried.empty()) return text + "; no folder is known to look in";
  text += "; tried ";
  const std::size_t listed = std::min(tried.size(), kMaxTriedListed);
  for (std::size_t i = 0; i < listed; ++i) text.append(i > 0 ? ", " : "").append(tried[i]);
  if (listed == tried.size()) return text;
  return text + " and " + std::to_string(tried.size() - listed) + " more: rigor resolve " +
         shell_word(uri) + " --from " + shell_word(file);
}

}  // namespace rigor::rules
