// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds what a path was meant to be when only the case of letters differs.
//
//   OtherCase(disk).find("Meshes/b.stl")   // "meshes/b.STL"

#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor {

/// Lists each folder once: ask one object for all paths. Safe across threads.
class OtherCase {
 public:
  explicit OtherCase(const Disk& disk) : disk_(disk) {}

  /// A path that is there and differs from this one only by letter case, in its name or in those of its
  /// folders; empty when there is none. On a file system that ignores case the asked-for spelling may
  /// open, yet fail on the next machine.
  std::string find(const std::string& path);

 private:
  /// What a folder holds, by the names in lower case.
  using Names = std::unordered_map<std::string, std::vector<std::string>>;

  const std::string& folder(std::string_view path);
  const Names& names(const std::string& folder);

  /// Most folders that are asked for are known: no string is made to look one up.
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };

  const Disk& disk_;
  std::mutex mutex_;
  /// As they are on the disk, or empty.
  std::unordered_map<std::string, std::string, Hash, std::equal_to<>> folders_;
  std::unordered_map<std::string, Names> names_;
};

}  // namespace rigor
