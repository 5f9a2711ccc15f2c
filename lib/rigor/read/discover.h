// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files a list of paths means: a file is itself, a folder is what it holds of models.
//
//   Discovered found = discover(disk, {"my_robot", "worlds/lab.world"});

#pragma once

#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::read {

struct LeftOut {
  std::string path;
  std::string why;
};

struct Discovered {
  std::vector<std::string> files;     ///< each once, in the order of the arguments, then by name
  std::vector<LeftOut> left_out;      ///< templates that somebody has to expand first
  std::vector<std::string> unusable;  ///< arguments that do not exist, and folders without a model
};

/// Folders are walked without following links upward: hidden ones (`.git`) are passed over.
Discovered discover(const Disk& disk, const std::vector<std::string>& paths);

}  // namespace rigor::read
