// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The disk as an untrusted model may use it.
//
//   const GuardedDisk disk(Reach(paths, search), {});

#pragma once

#include <memory>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

#include "project/reach.h"

namespace rigor::tool {

/// Out of reach only what has the name of a model, a mesh, a picture or a manifest is read: no YAML, no buffer, no
/// "/proc/self/environ", whose bytes would be a robot's. With a confinement nothing outside of its folders
/// is there at all. Links are followed first. Safe across threads.
class GuardedDisk final : public Disk {
 public:
  /// `confinement` holds real paths of folders (`real_path_of`); none is no confinement.
  GuardedDisk(Reach reach, std::vector<std::string> confinement)
      : reach_(std::move(reach)), confinement_(std::move(confinement)) {}

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override;

  const Reach& reach() const { return reach_; }

 private:
  bool confined_from(const std::string& path) const;
  /// Why the file is not read; empty when it may be.
  std::string refusal(const std::string& path) const;

  RealDisk disk_;
  Reach reach_;
  std::vector<std::string> confinement_;
};

}  // namespace rigor::tool
