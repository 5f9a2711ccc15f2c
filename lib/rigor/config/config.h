// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor.toml`: what a project says once instead of on every command line.
//
//   [materials]
//   our-foam = 42          # kg/m³
//
//   if (auto path = find_config(disk, "models/arm/model.sdf")) {
//     Config config = read_config(*path, bytes);
//   }
//
// The file nearest above the one that is looked at counts; the search ends at the root of a
// repository, which is a folder with `.git`.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::config {

/// Something that cannot stand in the file: "rigor.toml:3: …".
struct Problem {
  unsigned line = 0;  ///< 1-based
  std::string message;
};

struct Config {
  std::string path;
  std::map<std::string, double> materials;  ///< kg/m³, by name
  std::vector<Problem> problems;
};

/// The path of the configuration for a file or folder; nothing when there is none. `path` may be
/// relative: then the search begins in the working folder, and `working_folder` is its absolute path.
std::optional<std::string> find_config(const Disk& disk, std::string_view path,
                                       std::string_view working_folder);

/// Configurations are small; a larger file is none.
inline constexpr std::uint64_t kMaxConfigBytes = std::uint64_t{1} << 20U;

Config read_config(const std::string& path, std::string_view bytes);

}  // namespace rigor::config
