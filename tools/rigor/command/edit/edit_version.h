// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor edit upgrade|downgrade VERSION FILE...`; private to the command.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rigor/author/upgrade/downgrade.h>

namespace rigor::tool {

enum class VersionVerb : std::uint8_t { kUpgrade, kDowngrade };

/// Where the results go: to `out`, into the files, or to stdout as a diff, which as kCheckedDiff is a finding.
enum class EditTarget : std::uint8_t { kDiff, kCheckedDiff, kFiles, kOut };

struct VersionRequest {
  VersionVerb verb{};
  std::string version;  ///< "1.6"
  std::vector<std::string> files;
  std::vector<std::string> named;  ///< what the files were found by: themselves, or their folders
  author::VersionLosses losses = author::VersionLosses::kRefused;
  EditTarget target = EditTarget::kDiff;
  std::string out;
};

/// The exit code. `environment` reads the files.
int change_version(const Environment& environment, const VersionRequest& request);

}  // namespace rigor::tool
