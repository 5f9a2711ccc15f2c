// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The file system behind a seam, so that tests, editors and `validate -` need no real files.
//
//   RealDisk disk;
//   ReadResult file = disk.read("robot.sdf", kMaxModelBytes);
//   if (!file.bytes) complain(file.problem);
//
// Paths are UTF-8 with '/' between the parts.

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rigor {

enum class PathKind { kMissing, kFile, kFolder, kOther };

enum class ReadError : std::uint8_t { kOther, kTooLarge };

struct ReadResult {
  std::optional<std::string> bytes;
  std::string
      problem;  ///< why there are no bytes: "no such file", "is a folder", "is larger than 64 MiB"
  ReadError error = ReadError::kOther;  ///< of a file without bytes: `problem`, for programs
};

/// An open file, read piece by piece. Safe across threads.
class OpenFile {
 public:
  virtual ~OpenFile() = default;
  virtual std::uint64_t size() const = 0;

  /// Up to `count` bytes from `offset` into `into`; how many there were, which is fewer only at the
  /// end or when the disk fails.
  virtual std::size_t read(std::uint64_t offset, char* into, std::size_t count) const = 0;
};

class Disk {
 public:
  virtual ~Disk() = default;

  /// Nothing when it cannot be opened; `read` says why.
  virtual std::unique_ptr<OpenFile> open(const std::string& path) const = 0;

  /// All bytes of a file, or why not. A file over `max_bytes` is refused without being read.
  virtual ReadResult read(const std::string& path, std::uint64_t max_bytes) const = 0;

  virtual PathKind kind(const std::string& path) const = 0;

  /// Names (not paths) in a folder, sorted by bytes; empty when it is none. Links to folders are left
  /// out.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;

  /// Why the entry at the path counts as absent: "is a link to a file that does not exist", of a folder
  /// "cannot be listed: permission denied". Empty when nothing stands there, or nothing is wrong.
  virtual std::string obstacle(const std::string&) const { return {}; }
};

class RealDisk final : public Disk {
 public:
  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override;
};

/// Files from a map of path to bytes; their paths say which folders there are.
class MemoryDisk final : public Disk {
 public:
  MemoryDisk() = default;
  explicit MemoryDisk(std::map<std::string, std::string> files);
  void put(const std::string& path, std::string bytes);

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;

 private:
  struct Entry {
    std::optional<std::string> bytes;  // of a file
    std::set<std::string> names;       // what a folder holds
  };
  const Entry* find(const std::string& path) const;

  std::unordered_map<std::string, Entry> entries_;
};

}  // namespace rigor
