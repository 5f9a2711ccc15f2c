// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Remembers what a run asked of a disk, so that one can tell when it would be told something else:
// the files that it read, whatever includes and meshes they are, those that it missed, and the folders
// that it walked.
//
//   AskedDisk disk(real);
//   check(disk);                                // in place of the other
//   for (const std::string& folder : disk.folders()) watch(folder);
//   if (!disk.still_so()) check again;

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::tool {

/// Safe across threads.
class AskedDisk final : public Disk {
 public:
  /// Asks the other one, which outlives it.
  explicit AskedDisk(const Disk& disk) : disk_(disk) {}

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override { return disk_.obstacle(path); }

  /// The folders where a change of an answer is seen. Of what is not there, the nearest that is.
  std::set<std::string> folders() const;

  /// Whether every answer would be the same; of a file's bytes, by its size and time. Editors' own files
  /// (hidden ones, and those that end in `~`) do not count in a folder.
  bool still_so() const;

  std::size_t files_read() const;

 private:
  /// Of a file that was read.
  struct Stamp {
    std::uint64_t inode = 0;
    std::uint64_t size = 0;
    std::int64_t seconds = 0;
    std::int64_t nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp_of(const std::string& path);
  void keep_stamp(const std::string& path) const;
  std::vector<std::string> names_in(const std::string& folder) const;

  const Disk& disk_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, Stamp> stamps_;
  mutable std::map<std::string, PathKind> kinds_;
  mutable std::map<std::string, std::vector<std::string>> lists_;
};

}  // namespace rigor::tool
