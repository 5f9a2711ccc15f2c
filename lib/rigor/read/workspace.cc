// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/workspace.h>

#include <utility>

namespace rigor::read {

const File& Workspace::open(const std::string& path) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(path);
    if (found != files_.end()) return *found->second;
  }
  return keep(path, disk_.read(path, kMaxModelBytes));
}

const File& Workspace::put(const std::string& path, std::string bytes) {
  return keep(path, {std::move(bytes), {}});
}

const Resolution& Workspace::resolve(const Resolver& resolver, const std::string& uri,
                                     const std::string& from) {
  std::pair key(from, uri);
  {
    const std::lock_guard lock(mutex_);
    const auto found = resolved_.find(key);
    if (found != resolved_.end()) return found->second;
  }
  Resolution resolution = resolver.resolve(uri, from);
  const std::lock_guard lock(mutex_);
  return resolved_.try_emplace(std::move(key), std::move(resolution)).first->second;
}

std::optional<std::size_t> Workspace::parts(const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto found = parts_.find(path);
  if (found == parts_.end()) return std::nullopt;
  return found->second;
}

void Workspace::keep_parts(const std::string& path, std::size_t parts) {
  const std::lock_guard lock(mutex_);
  parts_.try_emplace(path, parts);
}

std::vector<const File*> Workspace::files() const {
  const std::lock_guard lock(mutex_);
  std::vector<const File*> files;
  for (const auto& [path, file] : files_) files.push_back(file.get());
  return files;
}

const File& Workspace::keep(const std::string& path, ReadResult read) {
  auto file = std::make_unique<File>();
  file->path = path;
  file->problem = std::move(read.problem);
  file->error = read.error;
  if (read.bytes) {
    file->source = sources_.add(path, std::move(*read.bytes));
    file->document = xml::parse(sources_.bytes(file->source), file->source);
  }
  // Two threads may have read the same file; the first to come here wins.
  const std::lock_guard lock(mutex_);
  return *files_.try_emplace(path, std::move(file)).first->second;
}

}  // namespace rigor::read
