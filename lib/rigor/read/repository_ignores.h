// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files a repository leaves out: its `.gitignore` files, and `.git/info/exclude`.
//
//   RepositoryIgnores ignores(disk, {"/home/me/robot"});
//   if (auto why = ignores.left_out("/home/me/robot/build", PathKind::kFolder)) say(*why);
//
// A folder belongs to the repository whose root is the nearest above it. Files of patterns count from that
// root down to the folder of what is asked for; the nearest is asked first. Outside of any repository
// those count that are in one of the top folders: an archive of a repository is then left out of as its
// clone is, and nobody's home folder has a say. What a user keeps for all of his repositories
// (core.excludesFile) is not read: the answer is the same on every machine.

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/gitignore.h>

namespace rigor::read {

/// A file of patterns over this size is not read, but told of (`unread`): the longest in use have some tens
/// of KiB, and each path is held against all of it, in a time that grows with the product of both.
inline constexpr std::uint64_t kMaxIgnoreBytes = std::uint64_t{256} << 10U;

class RepositoryIgnores {
 public:
  /// All paths here and below are normalized and, on a real disk, absolute.
  RepositoryIgnores(const Disk& disk, std::vector<std::string> tops);

  /// Which line leaves out this file or folder itself, "build/.gitignore line 3: *.sdf"; nothing when none
  /// does. Folders above it are not asked for.
  std::optional<std::string> left_out(const std::string& path, PathKind kind);

  /// The same, for it or any folder above it in its repository: what `git check-ignore --no-index` says.
  std::optional<std::string> left_out_with_folders(const std::string& path, PathKind kind);

  /// A file of patterns that counts and that could not be read: what it ignores is not left out.
  struct Unread {
    std::string path;
    std::string problem;  ///< "is larger than 256 KiB"
  };

  /// Of all that was asked so far, in the order in which they were met.
  const std::vector<Unread>& unread() const { return unread_; }

 private:
  struct PatternFile {
    std::string path;
    std::string folder;  ///< that its patterns are seen from
    IgnorePatterns patterns;
  };
  struct Folder {
    const Folder* above = nullptr;  ///< in the same repository
    std::string path;
    bool in_repository = false;
    std::vector<PatternFile> files;  ///< the first is asked first
  };

  const Folder* folder(const std::string& path);
  bool is_root(const std::string& path) const;
  bool is_below_a_top(std::string_view path) const;
  void read_patterns(Folder& folder, const std::string& file);

  const Disk& disk_;
  std::vector<std::string> tops_;
  std::map<std::string, std::unique_ptr<Folder>> folders_;
  std::vector<Unread> unread_;
};

/// Whether `path` is `folder` or in it; both are normalized.
bool is_within(std::string_view path, std::string_view folder);

}  // namespace rigor::read
