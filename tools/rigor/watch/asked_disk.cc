// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/asked_disk.h"

#include <sys/stat.h>

#include <algorithm>

#include <rigor/text/path.h>

namespace rigor::tool {

AskedDisk::Stamp AskedDisk::stamp_of(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

/// Before the bytes are read: a change in between is seen as one.
void AskedDisk::keep_stamp(const std::string& path) const {
  const Stamp stamp = stamp_of(path);
  const std::lock_guard lock(mutex_);
  stamps_.try_emplace(path, stamp);
}

std::vector<std::string> AskedDisk::names_in(const std::string& folder) const {
  std::vector<std::string> names = disk_.list(folder);
  const auto end = std::remove_if(names.begin(), names.end(), [](const std::string& name) {
    return (name.starts_with('.') && name != ".gitignore") || name.ends_with('~');
  });
  names.erase(end, names.end());
  return names;
}

std::unique_ptr<OpenFile> AskedDisk::open(const std::string& path) const {
  keep_stamp(path);
  return disk_.open(path);
}

ReadResult AskedDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  keep_stamp(path);
  return disk_.read(path, max_bytes);
}

PathKind AskedDisk::kind(const std::string& path) const {
  const PathKind kind = disk_.kind(path);
  const std::lock_guard lock(mutex_);
  kinds_.try_emplace(path, kind);
  return kind;
}

std::vector<std::string> AskedDisk::list(const std::string& folder) const {
  std::vector<std::string> names = names_in(folder);
  {
    const std::lock_guard lock(mutex_);
    lists_.try_emplace(folder, std::move(names));
  }
  return disk_.list(folder);
}

std::set<std::string> AskedDisk::folders() const {
  const std::lock_guard lock(mutex_);
  std::set<std::string> folders;
  std::map<std::string, bool> is_there;
  const auto add = [&](std::string folder) {
    while (true) {
      const auto [known, is_new] = is_there.try_emplace(folder, false);
      if (!is_new && known->second) return;
      if (is_new) known->second = disk_.kind(folder) == PathKind::kFolder;
      if (known->second) {
        folders.insert(folder);
        return;
      }
      if (folder == "/" || folder == "." || file_name(folder) == "..") return;
      folder = std::string(parent_path(folder));
    }
  };
  for (const auto& [path, stamp] : stamps_) add(std::string(parent_path(path)));
  for (const auto& [path, kind] : kinds_) add(std::string(parent_path(path)));
  for (const auto& [path, names] : lists_) add(path);
  return folders;
}

bool AskedDisk::still_so() const {
  const std::lock_guard lock(mutex_);
  return std::all_of(stamps_.begin(), stamps_.end(),
                     [](const auto& each) { return stamp_of(each.first) == each.second; }) &&
         std::all_of(kinds_.begin(), kinds_.end(),
                     [this](const auto& each) { return disk_.kind(each.first) == each.second; }) &&
         std::all_of(lists_.begin(), lists_.end(),
                     [this](const auto& each) { return names_in(each.first) == each.second; });
}

std::size_t AskedDisk::files_read() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      stamps_.begin(), stamps_.end(), [](const auto& each) { return each.second.inode != 0; }));
}

}  // namespace rigor::tool
