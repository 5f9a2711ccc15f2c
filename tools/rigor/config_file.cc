// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "config_file.h"

#include <filesystem>

#include "command.h"

namespace rigor::tool {

config::Config config_for(const std::string& path) {
  const RealDisk disk;
  const auto found = config::find_config(disk, path, std::filesystem::current_path().string());
  if (!found) return {};
  const ReadResult read = disk.read(*found, config::kMaxConfigBytes);
  if (!read.bytes) throw UsageError(*found + ": " + read.problem);
  config::Config config = config::read_config(*found, *read.bytes);
  if (!config.problems.empty()) {
    const config::Problem& first = config.problems.front();
    throw UsageError(*found + ":" + std::to_string(first.line) + ": " + first.message);
  }
  return config;
}

}  // namespace rigor::tool
