// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the `package.xml` of a ROS package says that leads to models.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::read {

/// Folders above a file that are examined for a package.xml or a model.config.
inline constexpr int kMaxAncestors = 16;

struct PackageManifest {
  std::string name;
  /// Folders that Gazebo is informed of, as by `<export><gazebo_ros gazebo_model_path="${prefix}/models"/>`;
  /// those below the package's own.
  std::vector<std::string> gazebo_folders;
};

/// Of the package that lies in `folder`; nothing when no package.xml of at most 1 MiB is there.
std::optional<PackageManifest> package_manifest(const Disk& disk, const std::string& folder);

}  // namespace rigor::read
