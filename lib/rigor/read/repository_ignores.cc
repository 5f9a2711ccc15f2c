// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/repository_ignores.h>

#include <algorithm>
#include <utility>

#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// `path` as seen from a folder that it is in.
std::string_view seen_from(std::string_view folder, std::string_view path) {
  if (folder == ".") return path;
  return path.substr(folder.ends_with('/') ? folder.size() : folder.size() + 1);
}

/// Empty when there is none, or when its name cannot be told.
std::string folder_above(std::string_view path) {
  if (path == "/" || path == "." || file_name(path) == "..") return {};
  return std::string(parent_path(path));
}

}  // namespace

bool is_within(std::string_view path, std::string_view folder) {
  if (folder == ".") return !is_absolute(path) && path != ".." && !path.starts_with("../");
  if (!path.starts_with(folder)) return false;
  return path.size() == folder.size() || folder.ends_with('/') || path[folder.size()] == '/';
}

RepositoryIgnores::RepositoryIgnores(const Disk& disk, std::vector<std::string> tops)
    : disk_(disk), tops_(std::move(tops)) {}

std::optional<std::string> RepositoryIgnores::left_out(const std::string& path, PathKind kind) {
  for (const Folder* at = folder(std::string(parent_path(path))); at != nullptr; at = at->above) {
    for (const PatternFile& file : at->files) {
      const IgnorePattern* last = file.patterns.last_match(seen_from(file.folder, path), kind);
      if (last == nullptr) continue;
      if (!last->ignores) return std::nullopt;
      return file.path + " line " + std::to_string(last->line) + ": " + last->text;
    }
  }
  return std::nullopt;
}

std::optional<std::string> RepositoryIgnores::left_out_with_folders(const std::string& path,
                                                                    PathKind kind) {
  std::vector<std::string> folders;
  for (const Folder* at = folder(std::string(parent_path(path))); at != nullptr; at = at->above) {
    if (at->above != nullptr) folders.push_back(at->path);
  }
  // What is in a folder that is left out is not examined, its patterns neither.
  for (auto outer = folders.rbegin(); outer != folders.rend(); ++outer) {
    if (auto why = left_out(*outer, PathKind::kFolder)) return why;
  }
  return left_out(path, kind);
}

const RepositoryIgnores::Folder* RepositoryIgnores::folder(const std::string& path) {
  std::vector<std::string> unknown;
  for (std::string at = path; !at.empty() && !folders_.contains(at); at = folder_above(at)) {
    unknown.push_back(at);
    if (is_root(at)) break;
  }
  for (auto next = unknown.rbegin(); next != unknown.rend(); ++next) {
    auto folder = std::make_unique<Folder>();
    folder->path = *next;
    if (is_root(*next)) {
      folder->in_repository = true;
      read_patterns(*folder, ".gitignore");
      read_patterns(*folder, ".git/info/exclude");
    } else {
      const auto above = folders_.find(folder_above(*next));
      if (above != folders_.end()) folder->above = above->second.get();
      folder->in_repository = folder->above != nullptr && folder->above->in_repository;
      if (folder->in_repository || is_below_a_top(*next)) read_patterns(*folder, ".gitignore");
    }
    folders_.emplace(*next, std::move(folder));
  }
  return folders_.at(path).get();
}

/// `.git` is a file in a submodule and in a worktree.
bool RepositoryIgnores::is_root(const std::string& path) const {
  return disk_.kind(join_path(path, ".git")) != PathKind::kMissing;
}

bool RepositoryIgnores::is_below_a_top(std::string_view path) const {
  return std::any_of(tops_.begin(), tops_.end(),
                     [path](const std::string& top) { return is_within(path, top); });
}

void RepositoryIgnores::read_patterns(Folder& folder, const std::string& file) {
  const std::string path = join_path(folder.path, file);
  if (disk_.kind(path) != PathKind::kFile) return;
  const ReadResult read = disk_.read(path, kMaxIgnoreBytes);
  if (!read.bytes) {
    unread_.push_back({path, read.problem});
    return;
  }
  IgnorePatterns patterns(*read.bytes);
  if (!patterns.empty()) folder.files.push_back({path, folder.path, std::move(patterns)});
}

}  // namespace rigor::read
