// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a file of an installed package lies in its source tree.
//
//   source_of_installed(disk, "/ws/src/arm/urdf/arm.xacro");   // "/ws/src/arm/description/urdf/arm.xacro"
//
// `$(find arm)` names the package's folder, which after installation is share/arm. What its CMakeLists.txt
// puts there from elsewhere, as by `install(DIRECTORY description/urdf DESTINATION share/${PROJECT_NAME})`,
// is looked for where it comes from.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::read {

/// A folder that is installed below share/PACKAGE: `from` of the source tree becomes `to`. Both are
/// relative; `to` is empty for share/PACKAGE itself.
struct InstalledFolder {
  std::string from;
  std::string to;
  bool operator==(const InstalledFolder&) const = default;
};

/// What a CMakeLists.txt says of folders, as far as it names them itself.
std::vector<InstalledFolder> installed_folders(std::string_view cmake);

/// For a path to no file; nothing when its package installs none there.
std::optional<std::string> source_of_installed(const Disk& disk, const std::string& path);

}  // namespace rigor::read
